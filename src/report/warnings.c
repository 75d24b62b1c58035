/* Says the warnings of a result in the report's languages. A result holds them in English, with
 * their numbers and names; here they are recognised by their pattern. */
#include "report/report.h"

#include <stdio.h>
#include <string.h>

/* "%" stands for a number or name, in the order of the English. A name that is a word of the
 * language ("front", "length") is translated too. */
static const struct {
    const char *english, *german;
} warnings[] = {
    {"%: mass assumed, % kg +- % % (one standard deviation): EES and delta-v follow it",
     "%: Masse angenommen, % kg +- % % (eine Standardabweichung): EES und Delta-v folgen ihr"},
    {"%: its mass as crashed, % kg, is less than its kerb mass, % kg: a car weighs that much when "
     "it is empty; check the two",
     "%: Masse beim Unfall, % kg, unter der Leermasse, % kg: so viel wiegt ein leerer Wagen; beide "
     "prüfen"},
    {"%: side struck by the wide %, but the sides of the models rest on narrow poles: depth and "
     "EES are estimates; own A, B stiffness of the side can be given",
     "%: Seite vom breiten % getroffen; die Seiten der Modelle beruhen auf schmalen Pfählen: Tiefe "
     "und EES sind Schätzungen; eigene Steifigkeiten A, B der Seite können angegeben werden"},
    {"%: side struck, and no model year: flanks of up to 2013 are dented a sixth deeper than "
     "computed, those of 2017 and later a tenth less; give \"built\"",
     "%: Seite getroffen, Baujahr unbekannt: Seiten bis 2013 werden um ein Sechstel tiefer "
     "eingedrückt als berechnet, ab 2017 um ein Zehntel weniger; \"built\" angeben"},
    {"%: small overlap outside the rails: tested cars slid off rounded edges and poles, the model "
     "holds on; take delta-v and EES as upper bounds",
     "%: geringe Überdeckung außerhalb der Längsträger: geprüfte Fahrzeuge glitten an runden "
     "Kanten und Pfählen ab, das Modell hält fest; Delta-v und EES sind obere Grenzen"},
    {"%: narrow object % without induced deformation: depth comes out about twice too large; use "
     "method extended or \"induced\": true",
     "%: schmales Objekt % ohne mitgezogene Verformung: die Tiefe wird etwa doppelt zu groß; "
     "Verfahren extended oder \"induced\": true verwenden"},
    {"%: closing speed % km/h is outside the % to % km/h of the % tests behind the models: depth "
     "and EES are extrapolated",
     "%: Annäherung % km/h liegt außerhalb von % bis % km/h der Versuche (%) hinter den Modellen: "
     "Tiefe und EES sind extrapoliert"},
    {"% with %: restitution % is above the % of measured crashes; set \"restitution\" lower or "
     "\"auto\"",
     "% mit %: Stoßziffer % liegt über % gemessener Kollisionen; \"restitution\" kleiner oder "
     "\"auto\" setzen"},
    {"%: struck at the rear, where the models rest on few tests: EES and depth are estimates; own "
     "A, B stiffness of the rear can be given",
     "%: am Heck getroffen, wo die Modelle auf wenigen Versuchen beruhen: EES und Tiefe sind "
     "Schätzungen; eigene Steifigkeiten A, B des Hecks können angegeben werden"},
    {"%: its own A, B leave the % uncrushed up to an EES of % km/h, where tests say 8 to 20: it "
     "acts as rigid; check the units, B is too small or A too large",
     "%: eigene Steifigkeiten A, B lassen: % bis zu einer EES von % km/h unverformt, wo Versuche 8 "
     "bis 20 nennen: das wirkt starr; Einheiten prüfen, B ist zu klein oder A zu groß"},
    {"%: its own B lets an EES of 50 km/h crush the % by no more than % m, where tests say 0.3 to "
     "0.6: it acts as rigid; check the units, B is too large",
     "%: die eigene Steifigkeit B lässt eine EES von 50 km/h so wenig eindrücken: %, höchstens % "
     "m, wo Versuche 0,3 bis 0,6 nennen: das wirkt starr; Einheiten prüfen, B ist zu groß"},
    {"%: EES % km/h is above the % km/h of the tests behind the models",
     "%: EES % km/h liegt über % km/h der Versuche hinter den Modellen"},
    {"%: crushed over % % of its %: structures behind that depth are an assumption of the model; "
     "check masses, speeds and overlap",
     "%: eingedrückt über % % von: %; was hinter dieser Tiefe liegt, ist eine Annahme des "
     "Modells; Massen, Geschwindigkeiten und Überdeckung prüfen"},
    {"%: delta-v % km/h lies outside the range of % injury risk functions: their probabilities are "
     "extrapolated and marked so",
     "%: Delta-v % km/h liegt außerhalb des Bereichs von % Verletzungsrisikofunktionen: ihre "
     "Wahrscheinlichkeiten sind extrapoliert und so gekennzeichnet"},
    {"the balance does not close: momentum %, energy % of the whole; a smaller \"dt_ms\" should "
     "cure it, please report the scene",
     "die Bilanz geht nicht auf: Impuls %, Energie % des Ganzen; ein kleineres \"dt_ms\" sollte "
     "helfen, die Szene bitte melden"},
    {"%: still moving after % s; brake it or take its rest position as that instant's",
     "%: nach % s noch in Bewegung; bremsen, oder die Endlage als die dieses Zeitpunkts nehmen"},
    {"% and % went through each other: %; no value of this impact can be relied on, check speeds, "
     "masses and heights",
     "% und % gingen durcheinander hindurch: %; auf keinen Wert dieses Stoßes ist Verlass, "
     "Geschwindigkeiten, Massen und Höhen prüfen"},
    {"% and % still approach by % km/h when their contact ends for want of material: they slide or "
     "slip past each other, or something is missing",
     "% und % nähern sich noch mit % km/h, wenn ihr Kontakt mangels Material endet: sie gleiten "
     "oder rutschen aneinander vorbei, oder es fehlt etwas"},
    {"% and % graze each other (% kJ of friction, % kJ of deformation): EES is good to 20 % at "
     "best; compare with half the voxel",
     "% und % streifen einander (% kJ Reibung, % kJ Verformung): die EES stimmt bestenfalls auf 20 "
     "%; mit halbem Voxel vergleichen"},
    {"% and % rub against each other for % s from % s on: that is no crash pulse, and what their "
     "tyres do in that time is in its delta-v",
     "% und % reiben % s lang aneinander, von % s an: das ist kein Kollisionspuls, und was die "
     "Reifen in dieser Zeit tun, steckt in seinem Delta-v"},
    {"%: % g in a plastic phase of % ms is no crash pulse: take its delta-v, not its "
     "accelerations",
     "%: % g in einer plastischen Phase von % ms ist kein Kollisionspuls: Delta-v verwenden, "
     "nicht die Beschleunigungen"},
    {"%: % % of its energy went in outside the contact: EES rests on the model of what is dragged "
     "along",
     "%: % % der Energie gingen außerhalb des Kontakts hinein: die EES beruht auf dem Modell der "
     "mitgezogenen Verformung"},
    {"%: yaw inertia % is far from the % that type and size give%",
     "%: Gierträgheitsmoment % liegt weit ab von %, wie Typ und Größe es ergeben%"},
    {"%: % % is far from the % that type and size give%",
     "%: % % liegt weit ab von %, wie Typ und Größe es ergeben%"},
    {"%: crushed by % m, beyond the A-pillar at % m: the compartment is an assumption of the "
     "model",
     "%: um % m eingedrückt, über die A-Säule bei % m hinaus: die Fahrgastzelle ist eine Annahme "
     "des Modells"},
    {"%: the force comes from % deg, at the border of two hours of the clock: its model might as "
     "well be the other; \"blend\": true mixes them",
     "%: die Kraft kommt aus % Grad, an der Grenze zweier Uhrzeiten: das Modell könnte auch das "
     "andere sein; \"blend\": true mischt beide"},
    {"%: the PDOF did not settle: model of % deg, force from % deg; set \"blend\": true or a fixed "
     "\"pdof_deg\" and compare",
     "%: die Stoßrichtung hat sich nicht eingestellt: Modell von % Grad, Kraft aus % Grad; "
     "\"blend\": true oder einen festen \"pdof_deg\" setzen und vergleichen"},
    {"%: \"pdof\" was read as % %: \"pdof_clock\" and \"pdof_deg\" say which of the two is meant",
     "%: \"pdof\" wurde als % % gelesen: \"pdof_clock\" und \"pdof_deg\" sagen, welches von beiden "
     "gemeint ist"},
    {"interrupted % ms after the first contact: every value is of that instant, none of the whole "
     "crash",
     "% ms nach dem Erstkontakt abgebrochen: jeder Wert gilt für diesen Zeitpunkt, keiner für die "
     "ganze Kollision"},
    {"%: % % % is not resolved: it moves by +-%% as grid, place and mass are nudged; see what "
     "happens there, give an interval",
     "%: % % % ist nicht aufgelöst: bewegt sich um +-%%, wenn Raster, Ort und Masse leicht "
     "verändert werden; ansehen, was dort geschieht, und einen Bereich angeben"},
    {"% of % nudged solves have no result: %",
     "% von % leicht veränderten Rechnungen haben kein Ergebnis: %"},
    {"%: its trajectory gives % km/h at % s, but its path runs at % km/h%; the contact is solved "
     "with the speed given",
     "%: die Bahn gibt % km/h bei % s an, ihr Weg läuft mit % km/h%; der Kontakt wird mit der "
     "angegebenen Geschwindigkeit gerechnet"},
    {"%: its trajectory jumps by % m within % s at % s",
     "%: die Bahn springt um % m innerhalb von % s bei % s"},
    {"%: its trajectory ends % s before its contact; until then it runs on with its last speed, "
     "course and yaw rate",
     "%: die Bahn endet % s vor dem Kontakt; bis dahin läuft sie mit letzter Geschwindigkeit, "
     "letztem Kurs und letzter Gierrate weiter"},
    {"more warnings than can be listed: solve the parts of this scene one by one",
     "mehr Warnungen als hier stehen können: die Teile dieser Szene einzeln rechnen"},
};

/* The parts of a text that stand where a pattern has "%". */
enum { HOLES = 8 };
struct holes {
    int n;
    const char *from[HOLES];
    size_t len[HOLES];
};

/* Whether a text follows a pattern. Each hole takes as little as lets the words behind it follow; a
 * percent sign in the text goes into a hole like a number. */
static bool fits(const char *pattern, const char *text, struct holes *holes) {
    for (holes->n = 0; *pattern != '\0';) {
        if (*pattern != '%') {
            if (*pattern++ != *text++) {
                return false;
            }
            continue;
        }
        size_t literal = strcspn(pattern + 1, "%");
        size_t len = 0, rest = strlen(text);
        if (literal == 0 && pattern[1] == '\0') {
            len = rest;
        } else {
            while (len + literal <= rest && strncmp(text + len, pattern + 1, literal) != 0) {
                len++;
            }
        }
        if (len + literal > rest || holes->n == HOLES) {
            return false;
        }
        holes->from[holes->n] = text;
        holes->len[holes->n++] = len;
        text += len;
        pattern++;
    }
    return *text == '\0';
}

void cr_warning_words(enum cr_lang lang, const char *english, struct cr_str *out) {
    struct holes holes;
    for (size_t i = 0; lang != CR_LANG_EN && i < sizeof warnings / sizeof warnings[0]; i++) {
        if (!fits(warnings[i].english, english, &holes)) {
            continue;
        }
        int hole = 0;
        for (const char *c = warnings[i].german; *c != '\0'; c++) {
            if (*c != '%' || hole == holes.n) {
                cr_str_addn(out, c, 1);
                continue;
            }
            char word[256];
            snprintf(word, sizeof word, "%.*s", (int)holes.len[hole], holes.from[hole]);
            cr_str_add(out, cr_words(lang, word));
            hole++;
        }
        return;
    }
    cr_str_add(out, english);
}
