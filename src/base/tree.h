/* Building JSON trees so that nothing is lost: where memory is out, the object or list that would
 * have missed something is spoiled, and cr_json_add (base/json.h) then refuses the whole tree. */
#ifndef CR_BASE_TREE_H
#define CR_BASE_TREE_H

#include <stdbool.h>

struct cJSON;

/* Add a member or element. What is added is taken over, also after a failure; NULL stands for what
 * could not be made. `to` NULL is the same a level higher, which is spoiled already. */
void cr_tree_put(struct cJSON *to, const char *key, struct cJSON *item);
void cr_tree_push(struct cJSON *list, struct cJSON *item);
void cr_tree_text(struct cJSON *to, const char *key, const char *text);
void cr_tree_number(struct cJSON *to, const char *key, double x);
void cr_tree_bool(struct cJSON *to, const char *key, bool on);
struct cr_str;
void cr_tree_str(struct cJSON *to, const char *key, const struct cr_str *text);
/* Whether nothing is missing, for a tree that is not written. */
bool cr_tree_whole(const struct cJSON *tree);
/* A new member to be filled; NULL where memory is out, which all of the above take. */
struct cJSON *cr_tree_array(struct cJSON *to, const char *key);
struct cJSON *cr_tree_object(struct cJSON *to, const char *key);

#endif
