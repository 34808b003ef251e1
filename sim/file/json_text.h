/* JSON as text that every reader accepts. */
#ifndef GLINT_SIM_FILE_JSON_TEXT_H
#define GLINT_SIM_FILE_JSON_TEXT_H

#include <cjson/cJSON.h>

/* As cJSON_Print(), to be freed with free(); NULL without memory, and for NULL. JSON is UTF-8, a
 * path may be any bytes: those that are not UTF-8 come out as U+FFFD, one for each byte. */
char *glint_json_text(const cJSON *json);

#endif
