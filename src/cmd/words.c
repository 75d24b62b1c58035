/* Words: of a list "a|b|c", of the command table, and the key of the scene behind an argument. */
#include "cmd/cmd_priv.h"

#include <stdio.h>
#include <string.h>

int cr_cmd_words(const char *words) {
    int n = words != NULL && words[0] != '\0';
    for (const char *p = words; n > 0 && *p != '\0'; p++) {
        n += *p == '|';
    }
    return n;
}

const char *cr_cmd_word_at(const char *words, int i, char *buf, int size) {
    const char *p = words;
    for (; i > 0; i--) {
        p = strchr(p, '|') + 1;
    }
    snprintf(buf, (size_t)size, "%.*s", (int)strcspn(p, "|"), p);
    return buf;
}

int cr_cmd_word_find(const char *words, const char *word) {
    char buf[64];
    int found = -1;
    for (int i = 0; i < cr_cmd_words(words); i++) {
        cr_cmd_word_at(words, i, buf, sizeof buf);
        if (strcmp(buf, word) == 0) {
            return i;
        }
        if (word[0] != '\0' && strncmp(buf, word, strlen(word)) == 0) {
            found = found == -1 ? i : -2;
        }
    }
    return found;
}

const char *cr_cmd_word_nearest(const char *words, const char *word, char *buf, int size) {
    char text[64][40];
    const char *list[64];
    int n = cr_cmd_words(words);
    n = n < 64 ? n : 64;
    for (int i = 0; i < n; i++) {
        list[i] = cr_cmd_word_at(words, i, text[i], sizeof text[i]);
    }
    const char *near = cr_str_nearest(word, list, n);
    if (near == NULL) {
        return NULL;
    }
    snprintf(buf, (size_t)size, "%s", near);
    return buf;
}

const struct cr_command *cr_command_among(const struct cr_command *table, int n, const char *word,
                                          bool *many) {
    const struct cr_command *found = NULL;
    size_t len = strlen(word);
    if (many != NULL) {
        *many = false;
    }
    for (int i = 0; i < n && len > 0; i++) {
        if (strcmp(table[i].name, word) == 0) {
            if (many != NULL) {
                *many = false;
            }
            return &table[i];
        }
        if (strncmp(table[i].name, word, len) == 0) {
            if (many != NULL) {
                *many = *many || found != NULL;
            }
            found = found == NULL ? &table[i] : found;
        }
    }
    return many != NULL && *many ? NULL : found;
}

const struct cr_key *cr_arg_key(const struct cr_arg *arg) {
    enum cr_key_table table = arg->mask != 0 ? CR_KEYS_PARTICIPANT : CR_KEYS_SETTINGS;
    if (arg->type != CR_VALUE_KEY) {
        return NULL;
    }
    /* a key that several kinds have in different rows is told by the first of them */
    for (unsigned bit = 1; bit <= CR_FOR_ALL; bit <<= 1) {
        if (arg->mask == 0 || (arg->mask & bit) != 0) {
            const struct cr_key *key = cr_scene_key_find(table, arg->key, arg->mask != 0 ? bit : 0);
            if (key != NULL) {
                return key;
            }
        }
    }
    return NULL;
}
