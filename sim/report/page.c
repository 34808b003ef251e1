/* cmark-gfm parses the Markdown; here its tree is changed to make the page self-contained. */
#define _POSIX_C_SOURCE 200809L

#include "report/page.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>
#include <nettle/base64.h>

#include "file/new_file.h"
#include "report/file_text.h"
#include "report/place.h"

#define TITLE_MAX 256

static const char style[] =
    ":root{color-scheme:light dark;--line:#8884;--soft:#8881}"
    "body{font:16px/1.5 system-ui,sans-serif;max-width:72em;margin:2em auto;padding:0 1em}"
    "h2{margin-top:2.5em;border-bottom:1px solid var(--line)}"
    "table{border-collapse:collapse;display:block;overflow-x:auto;margin:1em 0;"
    "font-variant-numeric:tabular-nums}"
    "th,td{padding:.25em .7em;border-bottom:1px solid var(--line);vertical-align:top}"
    "th{background:var(--soft)}img{max-width:100%;background:#fff}"
    "td[align=right]{white-space:nowrap}"
    /* A picture at the end of a row of numbers is as high as its text. */
    "td:nth-child(n+5) img{height:2em;max-width:none}"
    /* Figures stand two by two. */
    "figure{display:inline-block;width:47%;margin:0 2% 0 0;vertical-align:top}"
    "figure img{width:100%}figure p{margin:.3em 0}"
    "code{background:var(--soft);padding:0 .2em;border-radius:3px}"
    "pre{overflow-x:auto;background:var(--soft);padding:.7em}"
    "nav{background:var(--soft);padding:.7em 1em}nav ol{margin:0;columns:2}"
    ".holds{color:#1a7f37}.not{color:#c62828}.open{color:#9a6700}"
    "@media screen and (max-width:50em){figure{width:100%}nav ol{columns:1}}"
    "@media print{body{font-size:9px;max-width:none;margin:0}h2{margin-top:1.2em}"
    "table{display:table;overflow:visible}figure,tr{break-inside:avoid}}"
    "@page{margin:12mm}";

/* The bold text of each verdict, and its class in the style above. */
static const struct {
    const char *text, *class_name;
} verdicts[] = {{"holds", "holds"}, {"does not hold", "not"}, {"cannot be decided", "open"}};

/* ---- Pictures -------------------------------------------------------------------------------- */

static bool ends_with(const char *text, const char *end)
{
    const size_t length = strlen(text), end_length = strlen(end);
    return length >= end_length && strcmp(text + length - end_length, end) == 0;
}

/* "data:TYPE;base64,…", to be freed; NULL: no memory. */
static char *data_address(const char *type, const char *bytes, size_t size)
{
    const size_t head = strlen(type) + sizeof "data:;base64," - 1;
    char *address = malloc(head + BASE64_ENCODE_RAW_LENGTH(size) + 1);
    if (address == NULL)
        return NULL;
    snprintf(address, head + 1, "data:%s;base64,", type);
    base64_encode_raw(address + head, size, (const uint8_t *)bytes);
    address[head + BASE64_ENCODE_RAW_LENGTH(size)] = '\0';
    return address;
}

static glint_status put_in_picture(cmark_node *image, const char *directory, glint_error *err)
{
    const char *name = cmark_node_get_url(image);
    const char *type = ends_with(name, ".png")   ? "image/png"
                       : ends_with(name, ".svg") ? "image/svg+xml"
                                                 : NULL;
    if (type == NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "picture %.300s is neither .png nor .svg", name);
    glint_place place;
    char *bytes = NULL;
    size_t size = 0;
    glint_status status = glint_place_in(directory, name, &place, err);
    if (status == GLINT_OK)
        status = glint_file_text(place.path, &bytes, &size, err);
    if (status != GLINT_OK)
        return status;
    char *address = data_address(type, bytes, size);
    free(bytes);
    if (address == NULL || !cmark_node_set_url(image, address))
        status = glint_fail(err, GLINT_NO_MEMORY, "no memory for picture %.300s", place.path);
    free(address);
    return status;
}

/* ---- Headings and verdicts ------------------------------------------------------------------- */

/* The text of a node and all below it, cut at the room. */
static void text_of(cmark_node *node, char *text, size_t room)
{
    size_t length = 0;
    text[0] = '\0';
    cmark_iter *iter = cmark_iter_new(node);
    while (cmark_iter_next(iter) != CMARK_EVENT_DONE) {
        cmark_node *at = cmark_iter_get_node(iter);
        const cmark_node_type type = cmark_node_get_type(at);
        if (cmark_iter_get_event_type(iter) != CMARK_EVENT_ENTER)
            continue;
        const char *piece = type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE
                                ? cmark_node_get_literal(at)
                            : type == CMARK_NODE_SOFTBREAK ? " "
                                                           : "";
        const int wrote = snprintf(text + length, room - length, "%s", piece);
        length += (size_t)wrote < room - length ? (size_t)wrote : room - length - 1;
    }
    cmark_iter_free(iter);
}

static void print_escaped(FILE *out, const char *text)
{
    for (; *text != '\0'; text++)
        if (*text == '<')
            fputs("&lt;", out);
        else if (*text == '&')
            fputs("&amp;", out);
        else
            fputc(*text, out);
}

static cmark_node *raw_html(cmark_node_type type, const char *html)
{
    cmark_node *node = cmark_node_new(type);
    if (node != NULL)
        cmark_node_set_literal(node, html);
    return node;
}

/* Gives a heading of level 2 a place to jump to, and the contents a line. */
static void mark_heading(cmark_node *heading, int number, FILE *contents)
{
    char text[TITLE_MAX], anchor[64];
    text_of(heading, text, sizeof text);
    snprintf(anchor, sizeof anchor, "<a id=\"section-%d\"></a>", number);
    cmark_node_insert_before(heading, raw_html(CMARK_NODE_HTML_BLOCK, anchor));
    fprintf(contents, "<li><a href=\"#section-%d\">", number);
    print_escaped(contents, text);
    fputs("</a></li>\n", contents);
}

static void color_verdict(cmark_node *strong)
{
    char text[TITLE_MAX], html[TITLE_MAX];
    text_of(strong, text, sizeof text);
    for (size_t i = 0; i < sizeof verdicts / sizeof verdicts[0]; i++) {
        if (strcmp(text, verdicts[i].text) != 0)
            continue;
        snprintf(html, sizeof html, "<span class=\"%s\">", verdicts[i].class_name);
        cmark_node_insert_before(strong, raw_html(CMARK_NODE_HTML_INLINE, html));
        cmark_node_insert_after(strong, raw_html(CMARK_NODE_HTML_INLINE, "</span>"));
    }
}

/* ---- The page -------------------------------------------------------------------------------- */

/* Changes the tree as above; the lines of the contents come out. Returns the title's heading. */
static glint_status prepare(cmark_node *root, const char *directory, cmark_node **heading,
                            FILE *contents, glint_error *err)
{
    glint_status status = GLINT_OK;
    int sections = 0;
    cmark_iter *iter = cmark_iter_new(root);
    *heading = NULL;
    while (status == GLINT_OK && cmark_iter_next(iter) != CMARK_EVENT_DONE) {
        cmark_node *node = cmark_iter_get_node(iter);
        const cmark_node_type type = cmark_node_get_type(node);
        if (cmark_iter_get_event_type(iter) != CMARK_EVENT_EXIT)
            continue;
        if (type == CMARK_NODE_IMAGE)
            status = put_in_picture(node, directory, err);
        else if (type == CMARK_NODE_STRONG)
            color_verdict(node);
        else if (type == CMARK_NODE_HEADING && *heading == NULL)
            *heading = node;
        else if (type == CMARK_NODE_HEADING && cmark_node_get_heading_level(node) == 2)
            mark_heading(node, ++sections, contents);
    }
    cmark_iter_free(iter);
    return status;
}

static glint_status write_page(const char *path, const char *title, const char *body,
                               glint_error *err)
{
    glint_new_file *file;
    const glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width\">\n<title>",
          out);
    print_escaped(out, title);
    fprintf(out, "</title>\n<style>%s</style>\n</head>\n<body>\n%s</body>\n</html>\n", style, body);
    return glint_new_file_commit(file, err);
}

/* Makes the tree that of a page: pictures inside, the contents below the title. */
static glint_status change_tree(cmark_node *root, const char *directory, char *title,
                                glint_error *err)
{
    char *lines = NULL;
    size_t size = 0;
    cmark_node *heading;
    FILE *contents = open_memstream(&lines, &size);
    if (contents == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the page of %.300s", directory);
    fputs("<nav><ol>\n", contents);
    const glint_status status = prepare(root, directory, &heading, contents, err);
    fputs("</ol></nav>", contents);
    fclose(contents);
    if (status == GLINT_OK && heading != NULL) {
        text_of(heading, title, TITLE_MAX);
        cmark_node_insert_after(heading, raw_html(CMARK_NODE_HTML_BLOCK, lines));
    }
    free(lines);
    return status;
}

static glint_status make(const char *directory, const char *path, const char *markdown,
                         size_t length, glint_error *err)
{
    char title[TITLE_MAX] = "";
    cmark_gfm_core_extensions_ensure_registered();
    cmark_parser *parser = cmark_parser_new(CMARK_OPT_DEFAULT);
    cmark_parser_attach_syntax_extension(parser, cmark_find_syntax_extension("table"));
    cmark_parser_feed(parser, markdown, length);
    cmark_node *root = cmark_parser_finish(parser);
    glint_status status = change_tree(root, directory, title, err);
    if (status == GLINT_OK) {
        char *body =
            cmark_render_html(root, CMARK_OPT_UNSAFE, cmark_parser_get_syntax_extensions(parser));
        status = write_page(path, title, body, err);
        free(body);
    }
    cmark_node_free(root);
    cmark_parser_free(parser);
    return status;
}

glint_status glint_page_make(const char *directory, const char *name, glint_error *err)
{
    char file_name[TITLE_MAX];
    glint_place source, page;
    snprintf(file_name, sizeof file_name, "%s.md", name);
    glint_status status = glint_place_in(directory, file_name, &source, err);
    if (status != GLINT_OK)
        return status;
    snprintf(file_name, sizeof file_name, "%s.html", name);
    status = glint_place_in(directory, file_name, &page, err);
    if (status != GLINT_OK)
        return status;
    char *markdown;
    size_t length;
    status = glint_file_text(source.path, &markdown, &length, err);
    if (status != GLINT_OK)
        return status;
    status = make(directory, page.path, markdown, length, err);
    free(markdown);
    return status;
}
