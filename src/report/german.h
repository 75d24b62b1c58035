/* The German for every English text of the report and its pictures, sorted by the English, because
 * cr_words searches by halves. */
#ifndef CR_REPORT_GERMAN_H
#define CR_REPORT_GERMAN_H

static const struct {
    const char *english, *german;
} german_words[] = {
    {"%d draws (%s, seed %lu), %d without a result. The scatter of stiffness within a "
     "vehicle type, known from the calibration, is an input, and so is that of "
     "measured cars about the rules that assumed what was not given.",
     "%d Ziehungen (%s, Startwert %lu), %d ohne Ergebnis. Die Streuung der Steifigkeit "
     "innerhalb eines Fahrzeugtyps, bekannt aus der Kalibrierung, ist eine der Eingaben, ebenso "
     "die gemessener Fahrzeuge um die Regeln, nach denen Fehlendes angenommen wurde."},
    {"%d o'clock", "%d Uhr"},
    {"%s was measured on another face than the one that was struck.",
     "%s wurde an einer anderen Seite gemessen als der getroffenen."},
    {"1 Subject", "1 Gegenstand"},
    {"10 Validity", "10 Gültigkeit"},
    {"11 Limits, and what was not looked at", "11 Grenzen, und was nicht untersucht wurde"},
    {"12 How to repeat it", "12 Wiederholung"},
    {"13 Annex", "13 Anhang"},
    {"2 Question and summary", "2 Fragestellung und Zusammenfassung"},
    {"3 Inputs and their origin", "3 Eingaben und ihre Herkunft"},
    {"4 Method", "4 Verfahren"},
    {"5 The crash in pictures", "5 Die Kollision in Bildern"},
    {"6 Pulses", "6 Pulse"},
    {"7 Deformation and impacts", "7 Verformung und Stöße"},
    {"8 Balance", "8 Bilanz"},
    {"9 Uncertainty", "9 Unsicherheit"},
    {"ASI", "ASI"},
    {"Acceleration of the centres of gravity, CFC 60, over the time after first contact.",
     "Beschleunigung der Schwerpunkte, CFC 60, über der Zeit nach dem Erstkontakt."},
    {"After", "Nachher"},
    {"After the last contact. Dotted: ways of the centres of gravity.",
     "Nach dem letzten Kontakt. Gepunktet: Wege der Schwerpunkte."},
    {"Ages, seat positions and belts of occupants enter the injury risks only as far as "
     "the risk functions say.",
     "Alter, Sitzplatz und Gurt der Insassen gehen nur so weit ein, wie die "
     "Risikofunktionen es vorsehen."},
    {"Author", "Verfasser"},
    {"Before", "Vorher"},
    {"C1 to C6 stand at equal spaces over the width; they are measured square to the "
     "face from a straight line along the foremost point of the undeformed face, left "
     "to right on the ends and rear to front on the sides.",
     "C1 bis C6 stehen in gleichen Abständen über der Breite; sie sind rechtwinklig "
     "zur Seite gemessen, von einer Geraden durch den vordersten Punkt der unverformten "
     "Seite, an Front und Heck von links nach rechts, an den Flanken von hinten nach "
     "vorn."},
    {"C1,C6 over C3,C4", "C1, C6 zu C3, C4"},
    {"C1..C6 mean", "Mittel von C1 bis C6"},
    {"Case", "Aktenzeichen"},
    {"Commit", "Stand der Quellen (Commit)"},
    {"Convergence in time slice and voxel", "Konvergenz in Zeitschritt und Voxel"},
    {"Crash report: ", "Kollisionsbericht: "},
    {"Crash tests of the class that this crash belongs to (%s), computed with this "
     "program and these models: %d tests.",
     "Crashtests der Klasse, zu der diese Kollision gehört (%s), berechnet mit diesem "
     "Programm und diesen Modellen: %d Tests."},
    {"Date", "Datum"},
    {"Definition", "Definition"},
    {"Delta-v", "Delta-v"},
    {"Depth, m", "Tiefe, m"},
    {"Difference of the EES, %", "Unterschied der EES, %"},
    {"E: energy released in the slice, s: approach along the contact normal, COE: "
     "centre of energy, where the force acts. The compression ends when the approach "
     "momentum that is left is the elastic share; compression and restitution of that "
     "share follow.",
     "E: im Schritt freigesetzte Energie, s: Annäherung längs der Kontaktnormalen, "
     "COE: Energieschwerpunkt, in dem die Kraft angreift. Die Kompression endet, wenn "
     "der verbliebene Annäherungsimpuls der elastische Anteil ist; Kompression und "
     "Restitution dieses Anteils folgen."},
    {"EES", "EES"},
    {"Each vehicle is a plane grid of voxels. A voxel holds the energy that crushes it; "
     "together the voxels of a face give its EES over depth, calibrated to crash tests. "
     "Time runs in slices. In each slice the voxels in which two bodies overlap lose "
     "material and release their energy.",
     "Jedes Fahrzeug ist ein ebenes Raster aus Voxeln. Ein Voxel trägt die Energie, "
     "die ihn zerdrückt; zusammen ergeben die Voxel einer Seite deren EES über der "
     "Tiefe, kalibriert an Crashtests. Die Zeit läuft in Schritten. In jedem Schritt "
     "verlieren die Voxel, in denen zwei Körper sich überdecken, Material und setzen "
     "ihre Energie frei."},
    {"End", "Ende"},
    {"Energy", "Energie"},
    {"Every impact by itself", "Jeder Stoß für sich"},
    {"Every value that entered the computation. Values assumed by rule are marked in "
     "the margin; a value without tolerance was taken as exact.",
     "Alle Werte, die in die Berechnung eingingen. Nach Regel angenommene Werte sind am "
     "Rand markiert; ein Wert ohne Toleranz gilt als genau."},
    {"First contact", "Erstkontakt"},
    {"First contact.", "Erstkontakt."},
    {"Greatest acceleration", "Größte Beschleunigung"},
    {"Greatest acceleration, CFC 60", "Größte Beschleunigung, CFC 60"},
    {"Greatest depth, residual", "Größte Tiefe, bleibend"},
    {"Greatest engagement", "Größter Eingriff"},
    {"Greatest engagement: end of the plastic compression of the contact with the "
     "greatest impulse. Dashed: outlines before the crash.",
     "Größter Eingriff: Ende der plastischen Kompression des Kontakts mit dem "
     "größten Impuls. Gestrichelt: Umrisse vor der Kollision."},
    {"How severe was the crash for each vehicle: energy equivalent speed (EES), "
     "velocity change (delta-v), direction of force and deformation?",
     "Wie schwer war die Kollision für jedes Fahrzeug: energieäquivalente "
     "Geschwindigkeit (EES), Geschwindigkeitsänderung (delta-v), Stoßrichtung und "
     "Verformung?"},
    {"Imported from", "Importiert aus"},
    {"In brackets the range that holds 95 %% of %d computations with the inputs drawn "
     "from their tolerances (section 9).",
     "In Klammern der Bereich, in dem 95 %% von %d Berechnungen liegen, deren Eingaben "
     "aus ihren Toleranzen gezogen wurden (Abschnitt 9)."},
    {"In the crash", "In der Kollision"},
    {"Input", "Eingabe"},
    {"Input drawn", "Gezogene Eingabe"},
    {"Its data have the SHA-256 %s.", "Seine Daten haben den SHA-256 %s."},
    {"Left over, relative: energy %.1e, momentum %.1e, angular momentum %.1e.",
     "Rest, relativ: Energie %.1e, Impuls %.1e, Drehimpuls %.1e."},
    {"Length of the pulse", "Länge des Pulses"},
    {"Libraries", "Bibliotheken"},
    {"Linear regression over all draws; it explains %.0f %% of the variance.",
     "Lineare Regression über alle Ziehungen; sie erklärt %.0f %% der Varianz."},
    {"Mean acceleration", "Mittlere Beschleunigung"},
    {"Measure", "Größe"},
    {"Measured beside computed", "Gemessen neben berechnet"},
    {"Method", "Verfahren"},
    {"Middle", "Mitte"},
    {"Model of %s, SHA-256", "Modell von %s, SHA-256"},
    {"Motion, every %d. time slice", "Bewegung, jeder %d. Zeitschritt"},
    {"Moved: by how much the outer quantiles moved from half of the draws to all, the "
     "measure of convergence.",
     "Bewegt: um wie viel sich die äußeren Quantile von der Hälfte der Ziehungen zu "
     "allen verschoben, das Maß der Konvergenz."},
    {"Moves with", "Bewegt sich mit"},
    {"No crash tests were computed for comparison; crumple validate does that.",
     "Es wurden keine Crashtests zum Vergleich berechnet; das tut crumple validate."},
    {"No draws were made: %s.", "Es wurde nicht gezogen: %s."},
    {"No intervals: %s.", "Keine Bereiche: %s."},
    {"Note in the scene", "Anmerkung in der Szene"},
    {"OLC", "OLC"},
    {"Order", "Auftrag"},
    {"Origin", "Herkunft"},
    {"Partner", "Partner"},
    {"Peak, g", "Spitze, g"},
    {"Principal direction of force (PDOF)", "Stoßkraftrichtung (PDOF)"},
    {"Program", "Programm"},
    {"Program data, SHA-256", "Programmdaten, SHA-256"},
    {"Pulse, ms", "Puls, ms"},
    {"Red: the inputs as given.", "Rot: die Eingaben wie gegeben."},
    {"Result", "Ergebnis"},
    {"Result, SHA-256", "Ergebnis, SHA-256"},
    {"Risk functions, SHA-256", "Risikofunktionen, SHA-256"},
    {"Scene", "Szene"},
    {"Scene, SHA-256", "Szene, SHA-256"},
    {"Seen from above, to scale; x to the east, y to the north. Colours show the "
     "EES of a face that is crushed down to that voxel.",
     "Draufsicht, maßstäblich; x nach Osten, y nach Norden. Die Farben zeigen "
     "die EES einer Seite, die bis zu diesem Voxel eingedrückt ist."},
    {"Setting", "Einstellung"},
    {"Source: Breitlauch et al., A novel method for the automated simulation of various "
     "vehicle collisions to estimate crash severity, Traffic Injury Prevention 2023, "
     "S116-S123. The method \"extended\" adds friction between bodies, induced "
     "deformation, dynamic crush, heights and braking dive; \"paper\" is without them. "
     "The choices made stand in the program's method page.",
     "Quelle: Breitlauch et al., A novel method for the automated simulation of various "
     "vehicle collisions to estimate crash severity, Traffic Injury Prevention 2023, "
     "S116-S123. Das Verfahren \"extended\" ergänzt Reibung zwischen den Körpern, "
     "induzierte Verformung, dynamische Eindrückung, Höhen und Bremsnicken; \"paper\" "
     "ist ohne sie. Die getroffenen Festlegungen stehen auf der Verfahrensseite des "
     "Programms."},
    {"Speed after the crash", "Geschwindigkeit nach der Kollision"},
    {"Station", "Messstelle"},
    {"Struck face of %s from above, residual.", "Getroffene Seite von %s in Draufsicht, bleibend."},
    {"THIV", "THIV"},
    {"Test", "Test"},
    {"The computation is plane: rolling over, ramping and vaulting are not in it.",
     "Die Berechnung ist eben: Überschlag, Auffahren und Aufsteigen sind nicht "
     "enthalten."},
    {"The motion after the crash to rest was not computed (setting end).",
     "Die Bewegung nach der Kollision bis zum Stillstand wurde nicht berechnet "
     "(Einstellung end)."},
    {"The nearest tests", "Die nächstliegenden Tests"},
    {"The program gave no warning on this crash.",
     "Das Programm hat zu dieser Kollision nicht gewarnt."},
    {"The program was built from commit %s.",
     "Das Programm wurde aus dem Stand (Commit) %s gebaut."},
    {"The result file was computed again and differs: %s",
     "Die Ergebnisdatei wurde nachgerechnet und weicht ab: %s"},
    {"The result file was computed again: the same values.",
     "Die Ergebnisdatei wurde nachgerechnet: dieselben Werte."},
    {"The same on the 3D model of its type.", "Dasselbe am 3D-Modell des Typs."},
    {"The scene", "Die Szene"},
    {"The scene as it was given", "Die Szene, wie sie gegeben war"},
    {"The scene before the crash, with the speeds given.",
     "Die Szene vor der Kollision, mit den gegebenen Geschwindigkeiten."},
    {"The scene with every value", "Die Szene mit allen Werten"},
    {"The totals of section 2 add the sizes of the velocity changes of separate "
     "impacts; they are never netted.",
     "Die Summen in Abschnitt 2 addieren die Beträge der Geschwindigkeitsänderungen "
     "getrennter Stöße; sie werden nie gegeneinander aufgerechnet."},
    {"Tolerance", "Toleranz"},
    {"Trajectory of %d points, given.", "Bahn aus %d Punkten, gegeben."},
    {"Unit", "Einheit"},
    {"Value", "Wert"},
    {"Vehicle", "Fahrzeug"},
    {"Vehicles are represented by their type; an individual car differs from it. The "
     "scatter within a type is among the uncertainties, a repaired or corroded car is "
     "not.",
     "Fahrzeuge sind durch ihren Typ vertreten; ein einzelnes Fahrzeug weicht davon ab. "
     "Die Streuung innerhalb des Typs ist in der Unsicherheit enthalten, ein "
     "repariertes oder verrostetes Fahrzeug nicht."},
    {"What the scene says was measured (x_expect) was not compared: %s",
     "Was nach der Szene gemessen wurde (x_expect), wurde nicht verglichen: %s"},
    {"Whether the inputs are true was not examined here.",
     "Ob die Eingaben zutreffen, wurde hier nicht geprüft."},
    {"Width, m", "Breite, m"},
    {"With %s and the scene of section 13 in a file the following line makes this "
     "report again; the result then has the SHA-256 of section 1.",
     "Mit %s und der Szene aus Abschnitt 13 in einer Datei erzeugt die folgende Zeile "
     "diesen Bericht erneut; das Ergebnis hat dann die SHA-256 aus Abschnitt 1."},
    {"Yaw rates, unfiltered.", "Gierraten, ungefiltert."},
    {"absorbed", "aufgenommen"},
    {"acceleration severity index (EN 1317)", "Index der Beschleunigungsschwere (EN 1317)"},
    {"after first contact", "nach dem Erstkontakt"},
    {"along the face, m", "entlang der Seite, m"},
    {"as given", "wie gegeben"},
    {"assumed: from type and mass", "angenommen: aus Typ und Masse"},
    {"before first contact", "vor dem Erstkontakt"},
    {"car to car", "Pkw gegen Pkw"},
    {"catalogue: %s", "Katalog: %s"},
    {"computed", "berechnet"},
    {"computed, cm", "berechnet, cm"},
    {"crushed", "eingedrückt"},
    {"damaged area", "beschädigte Fläche"},
    {"deformable barriers", "verformbare Barrieren"},
    {"deformation", "Verformung"},
    {"deformed, depth in dm", "verformt, Tiefe in dm"},
    {"delta-v", "delta-v"},
    {"delta-v forward", "delta-v vorwärts"},
    {"delta-v left", "delta-v nach links"},
    {"delta-v over the length of the pulse", "delta-v durch die Länge des Pulses"},
    {"depth", "Tiefe"},
    {"depth dynamic, max", "größte Tiefe, dynamisch"},
    {"depth residual, max", "größte Tiefe, bleibend"},
    {"difference", "Unterschied"},
    {"difference, cm", "Unterschied, cm"},
    {"draws", "Ziehungen"},
    {"effect of each tolerance", "Wirkung jeder Toleranz"},
    {"energy", "Energie"},
    {"energy, kJ", "Energie, kJ"},
    {"flank struck by the US NCAP barrier", "Flanke, von der Barriere des US NCAP getroffen"},
    {"force", "Kraft"},
    {"force, kN", "Kraft, kN"},
    {"friction between bodies", "Reibung zwischen den Körpern"},
    {"from 5 % of the greatest acceleration on", "ab 5 % der größten Beschleunigung"},
    {"front", "Front"},
    {"full-width rigid wall", "starre Wand, volle Breite"},
    {"given", "gegeben"},
    {"heading, deg", "Gierwinkel, Grad"},
    {"imported", "importiert"},
    {"induced", "induziert"},
    {"injury risk", "Verletzungsrisiko"},
    {"input at its lower end", "Eingabe am unteren Ende"},
    {"input at its upper end", "Eingabe am oberen Ende"},
    {"interrupted", "abgebrochen"},
    {"interval not computed", "Bereich nicht berechnet"},
    {"kerb mass and load", "Leermasse und Zuladung"},
    {"kinetic", "kinetisch"},
    {"kinetic energy after", "kinetische Energie nachher"},
    {"kinetic energy before", "kinetische Energie vorher"},
    {"left", "links"},
    {"left side", "linke Seite"},
    {"length", "Länge"},
    {"low speed", "niedrige Geschwindigkeit"},
    {"mass", "Masse"},
    {"mean", "Mittel"},
    {"mean acceleration", "mittlere Beschleunigung"},
    {"mean error", "mittlerer Fehler"},
    {"measured", "gemessen"},
    {"measured, cm", "gemessen, cm"},
    {"median", "Median"},
    {"momentum", "Impuls"},
    {"moved", "bewegt"},
    {"ms", "ms"},
    {"narrow objects in front", "schmale Hindernisse frontal"},
    {"no-overlap", "ohne Überdeckung"},
    {"occupant load criterion: 65 mm free flight, 235 mm ride down",
     "Insassenbelastungskriterium: 65 mm freier Flug, 235 mm Rückhalteweg"},
    {"of the CG, filtered with CFC 60 (SAE J211)",
     "des Schwerpunkts, gefiltert mit CFC 60 (SAE J211)"},
    {"peak acceleration", "größte Beschleunigung"},
    {"planar yaw rate", "Gierrate des ebenen Stoßes"},
    {"pulse, rating of ISO/TS 18571", "Puls, Wertung nach ISO/TS 18571"},
    {"rear", "Heck"},
    {"residual crush C1 to C6", "bleibende Eindrückung C1 bis C6"},
    {"right", "rechts"},
    {"right side", "rechte Seite"},
    {"separation", "Trennung"},
    {"side", "Seite"},
    {"side pole, 254 mm, 75 deg, 32 km/h", "seitlicher Pfahl, 254 mm, 75 Grad, 32 km/h"},
    {"side, front at the right", "Seite, Front rechts"},
    {"small overlap, 64 km/h", "geringe Überdeckung, 64 km/h"},
    {"speed", "Geschwindigkeit"},
    {"struck from behind", "von hinten getroffen"},
    {"the centre of gravity of the one lay inside the other",
     "der Schwerpunkt des einen lag im anderen"},
    {"the one was cut through", "das eine wurde ganz durchtrennt"},
    {"the program's default", "Voreinstellung des Programms"},
    {"theoretical head impact velocity (EN 1317)",
     "theoretische Anprallgeschwindigkeit des Kopfes (EN 1317)"},
    {"they were switched off (--draws=0)", "abgeschaltet (--draws=0)"},
    {"this build has no GSL", "dieses Programm wurde ohne GSL gebaut"},
    {"time to depth", "Zeit bis zur größten Tiefe"},
    {"time to peak", "Zeit bis zur Spitze"},
    {"to", "bis"},
    {"top", "oben"},
    {"tyres", "Reifen"},
    {"width", "Breite"},
    {"yaw rate", "Gierrate"},
    {"yaw rate change", "Änderung der Gierrate"},
    {"yaw rate, deg/s", "Gierrate, Grad/s"},
    {"|a|", "|a|"},
};

#endif
