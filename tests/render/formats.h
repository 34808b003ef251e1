/* Writers of mesh files, for tests: a solid in each of the formats, without normals unless the
 * format cannot be without or the test gives them. Include it after cmocka.h, scratch.h and
 * solids.h. */
#ifndef GLINT_TESTS_RENDER_FORMATS_H
#define GLINT_TESTS_RENDER_FORMATS_H

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- A file in the making ----------------------------------------------------------------------
 */

typedef struct sheet {
    char at[1 << 20];
    size_t count;
} sheet;

static sheet page; /* one at a time is enough */

static inline void put_bytes(const void *bytes, size_t count)
{
    assert_true(page.count + count <= sizeof page.at);
    memcpy(page.at + page.count, bytes, count);
    page.count += count;
}

static inline void put(const char *format, ...)
{
    char line[512];
    va_list values;
    va_start(values, format);
    const int length = vsnprintf(line, sizeof line, format, values);
    va_end(values);
    assert_true(length >= 0 && (size_t)length < sizeof line);
    put_bytes(line, (size_t)length);
}

/* Little endian, as this machine need not be. */
static inline void put_number(uint32_t value, int bytes)
{
    for (int i = 0; i < bytes; i++) {
        const char byte = (char)(value >> (8 * i) & 0xff);
        put_bytes(&byte, 1);
    }
}

static inline uint32_t bits_of(double value)
{
    const float single = (float)value;
    uint32_t bits;
    memcpy(&bits, &single, sizeof bits);
    return bits;
}

static inline void put_float(double value)
{
    put_number(bits_of(value), 4);
}

static inline void put_point(const double p[3])
{
    for (int i = 0; i < 3; i++)
        put_float(p[i]);
}

/* The file is complete. */
static inline const char *put_down(const char *name)
{
    const char *path = scratch_path(name);
    scratch_write(path, page.at, page.count);
    page.count = 0;
    return path;
}

/* All vertices by one format of three numbers, all triangles by one of three indices. */
static inline void put_vertices(const solid *s, const char *format)
{
    for (size_t i = 0; i < s->vertices; i++)
        put(format, s->at[i][0], s->at[i][1], s->at[i][2]);
}

static inline void put_triangles(const solid *s, const char *format)
{
    for (size_t i = 0; i < s->triangles; i++)
        put(format, s->corner[i][0], s->corner[i][1], s->corner[i][2]);
}

/* ---- The formats -------------------------------------------------------------------------------
 */

static inline void put_obj(const solid *s)
{
    put_vertices(s, "v %.10g %.10g %.10g\n");
    for (size_t i = 0; i < s->triangles; i++)
        put("f %u %u %u\n", s->corner[i][0] + 1, s->corner[i][1] + 1, s->corner[i][2] + 1);
}

/* Each side of a cube in a material of its own, as an exporter splits it. */
static inline void put_obj_materials(const solid *s)
{
    put_vertices(s, "v %.10g %.10g %.10g\n");
    for (size_t i = 0; i < s->triangles; i++) {
        put("usemtl m%zu\nf %u %u %u\n", i / 2 % 3, s->corner[i][0] + 1, s->corner[i][1] + 1,
            s->corner[i][2] + 1);
    }
}

#define PLY_HEADER                                                                                 \
    "ply\nformat %s 1.0\nelement vertex %zu\nproperty float x\nproperty float y\n"                 \
    "property float z\nelement face %zu\nproperty list uchar int vertex_indices\nend_header\n"

static inline void put_ply(const solid *s)
{
    put(PLY_HEADER, "ascii", s->vertices, s->triangles);
    put_vertices(s, "%.10g %.10g %.10g\n");
    put_triangles(s, "3 %u %u %u\n");
}

static inline void put_ply_little(const solid *s)
{
    put(PLY_HEADER, "binary_little_endian", s->vertices, s->triangles);
    for (size_t i = 0; i < s->vertices; i++)
        put_point(s->at[i]);
    for (size_t i = 0; i < s->triangles; i++) {
        put_number(3, 1);
        for (int k = 0; k < 3; k++)
            put_number(s->corner[i][k], 4);
    }
}

static inline void put_big(uint32_t value)
{
    put_number(value << 24 | (value & 0xff00) << 8 | (value >> 8 & 0xff00) | value >> 24, 4);
}

static inline void put_ply_big(const solid *s)
{
    put(PLY_HEADER, "binary_big_endian", s->vertices, s->triangles);
    for (size_t i = 0; i < s->vertices; i++)
        for (int k = 0; k < 3; k++)
            put_big(bits_of(s->at[i][k]));
    for (size_t i = 0; i < s->triangles; i++) {
        put_number(3, 1);
        for (int k = 0; k < 3; k++)
            put_big(s->corner[i][k]);
    }
}

static inline void put_off(const solid *s)
{
    put("OFF\n%zu %zu 0\n", s->vertices, s->triangles);
    put_vertices(s, "%.10g %.10g %.10g\n");
    put_triangles(s, "3 %u %u %u\n");
}

static inline void put_amf(const solid *s)
{
    put("<?xml version=\"1.0\"?><amf unit=\"millimeter\"><object id=\"0\"><mesh><vertices>");
    put_vertices(s, "<vertex><coordinates><x>%.10g</x><y>%.10g</y><z>%.10g</z></coordinates>"
                    "</vertex>");
    put("</vertices><volume>");
    put_triangles(s, "<triangle><v1>%u</v1><v2>%u</v2><v3>%u</v3></triangle>");
    put("</volume></mesh></object></amf>");
}

static inline void put_dae(const solid *s)
{
    put("<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
        "version=\"1.4.1\"><asset><up_axis>Y_UP</up_axis></asset><library_geometries>");
    put("<geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"%zu\">",
        3 * s->vertices);
    put_vertices(s, "%.10g %.10g %.10g ");
    put("</float_array><technique_common><accessor source=\"#a\" count=\"%zu\" stride=\"3\">"
        "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
        "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>",
        s->vertices);
    put("<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
        "<triangles count=\"%zu\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>",
        s->triangles);
    put_triangles(s, "%u %u %u ");
    put("</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
        "<visual_scene id=\"s\"><node id=\"n\"><instance_geometry url=\"#g\"/></node>"
        "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene>"
        "</COLLADA>");
}

/* Left-handed: z the other way round, and with it the order of corners. */
static inline void put_x(const solid *s)
{
    put("xof 0303txt 0032\nMesh a {\n%zu;\n", s->vertices);
    for (size_t i = 0; i < s->vertices; i++) {
        put("%.10f;%.10f;%.10f;%s\n", s->at[i][0], s->at[i][1], -s->at[i][2],
            i + 1 < s->vertices ? "," : ";");
    }
    put("%zu;\n", s->triangles);
    for (size_t i = 0; i < s->triangles; i++) {
        put("3;%u,%u,%u;%s\n", s->corner[i][0], s->corner[i][2], s->corner[i][1],
            i + 1 < s->triangles ? "," : ";");
    }
    put("}\n");
}

static inline void put_ac(const solid *s)
{
    put("AC3Db\nMATERIAL \"a\" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0\n"
        "OBJECT world\nkids 1\nOBJECT poly\nnumvert %zu\n",
        s->vertices);
    put_vertices(s, "%.10g %.10g %.10g\n");
    put("numsurf %zu\n", s->triangles);
    put_triangles(s, "SURF 0x0\nmat 0\nrefs 3\n%u 0 0\n%u 0 0\n%u 0 0\n");
    put("kids 0\n");
}

static inline void put_x3d(const solid *s)
{
    put("<?xml version=\"1.0\" encoding=\"UTF-8\"?><X3D profile=\"Interchange\" version=\"3.0\">"
        "<Scene><Shape><IndexedFaceSet solid=\"true\" coordIndex=\"");
    put_triangles(s, "%u %u %u -1 ");
    put("\"><Coordinate point=\"");
    put_vertices(s, "%.10g %.10g %.10g ");
    put("\"/></IndexedFaceSet></Shape></Scene></X3D>\n");
}

static inline void put_raw(const solid *s)
{
    for (size_t i = 0; i < s->triangles; i++) {
        for (size_t k = 0; k < 3; k++) {
            const double *p = s->at[s->corner[i][k]];
            put("%.10g %.10g %.10g%c", p[0], p[1], p[2], k < 2 ? ' ' : '\n');
        }
    }
}

/* z is up */
static inline void put_dxf(const solid *s)
{
    put("0\nSECTION\n2\nENTITIES\n");
    for (size_t i = 0; i < s->triangles; i++) {
        put("0\n3DFACE\n8\n0\n");
        for (size_t k = 0; k < 4; k++) {
            const double *p = s->at[s->corner[i][k < 3 ? k : 2]];
            put("%zu\n%.10g\n%zu\n%.10g\n%zu\n%.10g\n", 10 + k, p[0], 20 + k, -p[2], 30 + k, p[1]);
        }
    }
    put("0\nENDSEC\n0\nEOF\n");
}

/* ---- .stl: a normal for each facet -------------------------------------------------------------
 */

static inline void put_stl_with(const solid *s, const char *normal)
{
    put("solid a\n");
    for (size_t i = 0; i < s->triangles; i++) {
        put("facet normal %s\nouter loop\n", normal);
        for (size_t k = 0; k < 3; k++) {
            const double *p = s->at[s->corner[i][k]];
            put("vertex %.10g %.10g %.10g\n", p[0], p[1], p[2]);
        }
        put("endloop\nendfacet\n");
    }
    put("endsolid a\n");
}

static inline void put_stl(const solid *s)
{
    put_stl_with(s, "0 0 0");
}

/* n: of every facet; NULL: its own. */
static inline void put_stl_binary_with(const solid *s, const double *n)
{
    const char header[80] = "";
    put_bytes(header, sizeof header);
    put_number((uint32_t)s->triangles, 4);
    for (size_t i = 0; i < s->triangles; i++) {
        const glint_vec3 plane = solid_plane(s, i);
        const double own[3] = {plane.x, plane.y, plane.z};
        put_point(n != NULL ? n : own);
        for (size_t k = 0; k < 3; k++)
            put_point(s->at[s->corner[i][k]]);
        put_number(0, 2);
    }
}

static inline void put_stl_binary(const solid *s)
{
    put_stl_binary_with(s, NULL);
}

/* ---- glTF --------------------------------------------------------------------------------------
 */

static inline void put_base64(const char *bytes, size_t count)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < count; i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; k++)
            bits = bits << 8 | (i + k < count ? (uint8_t)bytes[i + k] : 0u);
        for (size_t k = 0; k < 4; k++)
            put("%c", i + k > count ? '=' : digit[bits >> (18 - 6 * k) & 63]);
    }
}

/* Positions, indices and, with a length, normals as long as that along each vertex's own place. */
static inline size_t gltf_content(const solid *s, bool normals, double length, char *content)
{
    const size_t begin = page.count;
    for (size_t i = 0; i < s->vertices; i++)
        put_point(s->at[i]);
    for (size_t i = 0; i < s->triangles; i++)
        for (size_t k = 0; k < 3; k++)
            put_number(s->corner[i][k], 4);
    for (size_t i = 0; normals && i < s->vertices; i++) {
        const double n[3] = {length * s->at[i][0], length * s->at[i][1], length * s->at[i][2]};
        put_point(n);
    }
    const size_t count = page.count - begin;
    memcpy(content, page.at + begin, count);
    page.count = begin;
    return count;
}

/* Up to the buffer's bytes, which follow in base 64 or stand outside. */
static inline void put_gltf_json(const solid *s, bool normals, size_t bytes)
{
    const size_t place = 12 * s->vertices, index = 12 * s->triangles;
    put("{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0%s},"
        "\"indices\":1}]}],",
        normals ? ",\"NORMAL\":2" : "");
    put("\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":%zu},"
        "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}",
        place, place, index);
    if (normals)
        put(",{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}", place + index, place);
    put("],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%zu,"
        "\"type\":\"VEC3\",\"min\":[-1,-1,-1],\"max\":[1,1,1]},{\"bufferView\":1,"
        "\"componentType\":5125,\"count\":%zu,\"type\":\"SCALAR\"}",
        s->vertices, 3 * s->triangles);
    if (normals) {
        put(",{\"bufferView\":2,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\"}",
            s->vertices);
    }
    put("],\"buffers\":[{\"byteLength\":%zu", bytes);
}

static inline void put_gltf_with(const solid *s, bool normals, double length)
{
    static char content[1 << 18];
    const size_t count = gltf_content(s, normals, length, content);
    put_gltf_json(s, normals, count);
    put(",\"uri\":\"data:application/octet-stream;base64,");
    put_base64(content, count);
    put("\"}]}");
}

static inline void put_gltf(const solid *s)
{
    put_gltf_with(s, false, 0.0);
}

static inline void put_glb(const solid *s)
{
    static char content[1 << 18], json[4096];
    const size_t count = gltf_content(s, false, 0.0, content);
    put_gltf_json(s, false, count);
    put("}]}");
    while (page.count % 4 != 0)
        put(" ");
    const size_t length = page.count;
    assert_true(length <= sizeof json);
    memcpy(json, page.at, length);
    page.count = 0;
    put_bytes("glTF", 4);
    put_number(2, 4);
    put_number((uint32_t)(12 + 8 + length + 8 + count), 4);
    put_number((uint32_t)length, 4);
    put_bytes("JSON", 4);
    put_bytes(json, length);
    put_number((uint32_t)count, 4);
    put_bytes("BIN", 4);
    put_bytes(content, count);
}

/* ---- .3mf: a zip archive, nothing compressed ---------------------------------------------------
 */

static inline uint32_t crc_of(const char *bytes, size_t count)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < count; i++) {
        crc ^= (uint8_t)bytes[i];
        for (int k = 0; k < 8; k++)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

typedef struct zip_entry {
    const char *name;
    size_t begin, count;
    uint32_t crc, at;
} zip_entry;

/* What both headers of an entry have in common. */
static inline void put_zip_fields(const zip_entry *e)
{
    put_number(20, 2);
    put_number(0, 4); /* flags, method */
    put_number(0x00210000, 4);
    put_number(e->crc, 4);
    put_number((uint32_t)e->count, 4);
    put_number((uint32_t)e->count, 4);
    put_number((uint32_t)strlen(e->name), 2);
    put_number(0, 2);
}

static inline void put_zip(zip_entry *entry, size_t entries, const char *content)
{
    for (size_t i = 0; i < entries; i++) {
        entry[i].crc = crc_of(content + entry[i].begin, entry[i].count);
        entry[i].at = (uint32_t)page.count;
        put_number(0x04034b50, 4);
        put_zip_fields(&entry[i]);
        put("%s", entry[i].name);
        put_bytes(content + entry[i].begin, entry[i].count);
    }
    const size_t directory = page.count;
    for (size_t i = 0; i < entries; i++) {
        put_number(0x02014b50, 4);
        put_number(20, 2);
        put_zip_fields(&entry[i]);
        put_number(0, 4);
        put_number(0, 4);
        put_number(0, 2); /* comment, disk, attributes */
        put_number(entry[i].at, 4);
        put("%s", entry[i].name);
    }
    const size_t size = page.count - directory;
    put_number(0x06054b50, 4);
    put_number(0, 4);
    put_number((uint32_t)entries, 2);
    put_number((uint32_t)entries, 2);
    put_number((uint32_t)size, 4);
    put_number((uint32_t)directory, 4);
    put_number(0, 2);
}

static inline void put_3mf(const solid *s)
{
    static char content[1 << 18];
    zip_entry entry[3] = {{"[Content_Types].xml", 0, 0, 0, 0},
                          {"_rels/.rels", 0, 0, 0, 0},
                          {"3D/3dmodel.model", 0, 0, 0, 0}};
    put("<?xml version=\"1.0\"?><Types xmlns=\"http://schemas.openxmlformats.org/package/2006/"
        "content-types\"><Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-"
        "package.relationships+xml\"/><Default Extension=\"model\" ContentType=\"application/"
        "vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>");
    entry[0].count = page.count;
    entry[1].begin = page.count;
    put("<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/"
        "2006/relationships\"><Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>");
    entry[1].count = page.count - entry[1].begin;
    entry[2].begin = page.count;
    put("<?xml version=\"1.0\"?><model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/"
        "3dmanufacturing/core/2015/02\"><resources><object id=\"1\" type=\"model\"><mesh>"
        "<vertices>");
    put_vertices(s, "<vertex x=\"%.10g\" y=\"%.10g\" z=\"%.10g\"/>");
    put("</vertices><triangles>");
    put_triangles(s, "<triangle v1=\"%u\" v2=\"%u\" v3=\"%u\"/>");
    put("</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>");
    entry[2].count = page.count - entry[2].begin;
    assert_true(page.count <= sizeof content);
    memcpy(content, page.at, page.count);
    page.count = 0;
    put_zip(entry, 3, content);
}

/* ---- .3ds --------------------------------------------------------------------------------------
 */

/* Begins a chunk; its size is put in when it ends. */
static inline size_t begin_chunk(uint32_t kind)
{
    put_number(kind, 2);
    put_number(0, 4);
    return page.count - 6;
}

static inline void end_chunk(size_t at)
{
    const size_t end = page.count;
    page.count = at + 2;
    put_number((uint32_t)(end - at), 4);
    page.count = end;
}

/* Every third face of another material, which the readers keep apart. */
static inline void put_3ds_materials(const solid *s)
{
    for (uint32_t m = 0; m < 2; m++) {
        const size_t list = begin_chunk(0x4130);
        uint32_t count = 0;
        for (size_t i = 0; i < s->triangles; i++)
            count += (i % 3 == 0) == (m == 0);
        put("m%u", m);
        put_number(0, 1);
        put_number(count, 2);
        for (size_t i = 0; i < s->triangles; i++)
            if ((i % 3 == 0) == (m == 0))
                put_number((uint32_t)i, 2);
        end_chunk(list);
    }
}

static inline void put_3ds_object(const solid *s, const char *name, bool groups, bool materials)
{
    const size_t object = begin_chunk(0x4000);
    put_bytes(name, strlen(name) + 1);
    const size_t mesh = begin_chunk(0x4100);
    const size_t vertices = begin_chunk(0x4110);
    put_number((uint32_t)s->vertices, 2);
    for (size_t i = 0; i < s->vertices; i++) { /* z is up */
        const double p[3] = {s->at[i][0], -s->at[i][2], s->at[i][1]};
        put_point(p);
    }
    end_chunk(vertices);
    const size_t faces = begin_chunk(0x4120);
    put_number((uint32_t)s->triangles, 2);
    for (size_t i = 0; i < s->triangles; i++) {
        for (size_t k = 0; k < 3; k++)
            put_number(s->corner[i][k], 2);
        put_number(7, 2);
    }
    if (materials)
        put_3ds_materials(s);
    if (groups) {
        const size_t list = begin_chunk(0x4150);
        for (size_t i = 0; i < s->triangles; i++)
            put_number(s->group[i], 4);
        end_chunk(list);
    }
    end_chunk(faces);
    end_chunk(mesh);
    end_chunk(object);
}

/* Each of the solids as an object. */
static inline void put_3ds(const solid *const *solids, size_t count, bool groups, bool materials)
{
    const size_t file = begin_chunk(0x4d4d);
    const size_t editor = begin_chunk(0x3d3d);
    for (uint32_t m = 0; materials && m < 2; m++) {
        const size_t material = begin_chunk(0xafff);
        const size_t name = begin_chunk(0xa000);
        put("m%u", m);
        put_number(0, 1);
        end_chunk(name);
        end_chunk(material);
    }
    for (size_t i = 0; i < count; i++) {
        const char name[2] = {(char)('a' + i), '\0'};
        put_3ds_object(solids[i], name, groups, materials);
    }
    end_chunk(editor);
    end_chunk(file);
}

/* ---- .ase --------------------------------------------------------------------------------------
 */

/* The numbers of a face's groups, as they stand in the file. */
static inline void put_ase_groups(uint32_t group)
{
    const char *before = " *MESH_SMOOTHING ";
    for (int k = 0; k < 32; k++) {
        if ((group >> k & 1) != 0) {
            put("%s%d", before, k + 1);
            before = ",";
        }
    }
}

/* z is up. */
static inline void put_ase(const solid *s, bool groups, bool materials)
{
    put("*3DSMAX_ASCIIEXPORT 200\n");
    if (materials) {
        put("*MATERIAL_LIST {\n*MATERIAL_COUNT 1\n*MATERIAL 0 {\n*MATERIAL_NAME \"m\"\n"
            "*NUMSUBMTLS 2\n*SUBMATERIAL 0 {\n*MATERIAL_NAME \"m0\"\n}\n"
            "*SUBMATERIAL 1 {\n*MATERIAL_NAME \"m1\"\n}\n}\n}\n");
    }
    put("*GEOMOBJECT {\n*NODE_NAME \"a\"\n*MESH {\n*MESH_NUMVERTEX %zu\n*MESH_NUMFACES %zu\n",
        s->vertices, s->triangles);
    put("*MESH_VERTEX_LIST {\n");
    for (size_t i = 0; i < s->vertices; i++)
        put("*MESH_VERTEX %zu %.10g %.10g %.10g\n", i, s->at[i][0], -s->at[i][2], s->at[i][1]);
    put("}\n*MESH_FACE_LIST {\n");
    for (size_t i = 0; i < s->triangles; i++) {
        put("*MESH_FACE %zu: A: %u B: %u C: %u AB: 1 BC: 1 CA: 1", i, s->corner[i][0],
            s->corner[i][1], s->corner[i][2]);
        if (groups)
            put_ase_groups(s->group[i]);
        put(" *MESH_MTLID %d\n", i % 3 == 0);
    }
    put("}\n}\n%s}\n", materials ? "*MATERIAL_REF 0\n" : "");
}

/* What is on the page, as UTF-16 with a byte order mark. */
static inline void widen_page(bool big)
{
    static char plain[1 << 20];
    const size_t count = page.count;
    memcpy(plain, page.at, count);
    page.count = 0;
    put_bytes(big ? "\xfe\xff" : "\xff\xfe", 2);
    for (size_t i = 0; i < count; i++) {
        const char unit[2] = {big ? '\0' : plain[i], big ? plain[i] : '\0'};
        put_bytes(unit, 2);
    }
}

#endif
