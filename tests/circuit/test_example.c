/* The example of docs/your-circuit.md: the command does to docs/examples/saturating_mac what that
 * page says. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../cli/run.h"
#include "own.h"

#define MAC  "docs/examples/saturating_mac"
#define PAGE "docs/your-circuit.md"

/* The page shows the command's words, each line indented. */
static void assert_page_has(const char *lines)
{
    char wanted[256];
    char *page = scratch_read(PAGE, NULL);
    for (int i = 0; i < 3 && *lines != '\0'; i++) {
        const int length = (int)strcspn(lines, "\n");
        (void)snprintf(wanted, sizeof wanted, "    %.*s\n", length, lines);
        assert_says(page, wanted);
        lines += length + (lines[length] == '\n');
    }
    free(page);
}

static void what_it_is_taken_for_is_told(void **state)
{
    (void)state;
    outcome done = own_run(MAC, "", "info");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "Saturating multiply-accumulate");
    assert_says(done.out, "262144 points");
    forget(&done);
}

static void it_is_verified(void **state)
{
    (void)state;
    outcome done = own_run(MAC, "", "verify --clocks 20000 --width all");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "0 mismatches of ");
    assert_says(done.out, " 3 settings");
    forget(&done);
}

/* Every pair of factors, four times in a row; the number is counted, not taken from it. */
static void every_input_is_tried(void **state)
{
    (void)state;
    outcome done = own_run(MAC, "", "verify --exhaustive");
    assert_outcome(&done, 0, "");
    assert_page_has("saturating_mac, width 8: every a with every b, four times to a sum: 262144 of "
                    "262144 points\n");
    assert_says(done.out, "262144 of 262144 points");
    forget(&done);
    done = own_run(MAC, "", "verify --exhaustive --width 4 --json");
    assert_outcome(&done, 0, NULL);
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    assert_int_equal(json_integer_value(json_object_get(json, "mismatches")), 0);
    assert_non_null(strstr(done.out, "1024")); /* points: 4 * 2^4 * 2^4 */
    json_decref(json);
    forget(&done);
    done = own_run(MAC, "", "verify --exhaustive --width 16");
    assert_own_refused(&done, "saturating_mac, width 16");
    forget(&done);
}

static void eval_has_the_right_numbers(void **state)
{
    (void)state;
    static const char input[] = "3 4\n-128 -128\n-128,-128\n127 -128\n";
    static const char output[] = "a,b,out_valid,out_saturated,out_sum\n"
                                 "3,4,1,0,12\n"
                                 "-128,-128,1,0,16396\n"
                                 "-128,-128,1,1,32767\n"
                                 "127,-128,1,0,16511\n";
    static const char named[] = "a b first\n3 4 1\n5 6 1\n";
    static const char answered[] = "a,b,first,out_valid,out_saturated,out_sum\n"
                                   "3,4,1,1,0,12\n"
                                   "5,6,1,1,0,30\n";
    static const char *const backends[] = {"c", "rtl"};
    for (size_t i = 0; i < 4; i++) {
        outcome done = own_run(MAC, i < 2 ? input : named, "eval --backend %s", backends[i % 2]);
        assert_outcome(&done, 0, "");
        assert_string_equal(done.out, i < 2 ? output : answered);
        assert_page_has(done.out);
        forget(&done);
    }
}

/* The sum no longer stops at its lower end. */
static void a_fault_is_found_looked_at_and_played_again(void **state)
{
    (void)state;
    char wrong[OWN_PATH], packet[OWN_PATH];
    own_copy(MAC, "wrong", wrong);
    own_edit(wrong, "saturating_mac.v", "added[2*WIDTH] != added[2*WIDTH-1]",
             "!added[2*WIDTH] && added[2*WIDTH-1]");
    outcome done =
        own_run(MAC, "", "verify --width 8 --rtl %s --out %s", wrong, scratch_path("packets"));
    assert_int_equal(done.status, 1);
    assert_says(done.out, "beyond");
    forget(&done);

    own_only_entry(scratch_path("packets"), packet);
    static const char *const files[] = {"report.txt", "wave.vcd", "wave.gtkw", "failure.json"};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        char path[OWN_PATH + 100];
        (void)snprintf(path, sizeof path, "%s/%s", packet, files[i]);
        assert_int_equal(access(path, R_OK), 0);
    }
    done = own_run(MAC, "", "replay %s --rtl %s", packet, wrong);
    assert_int_equal(done.status, 1);
    forget(&done);
    done = own_run(MAC, "", "replay %s", packet);
    assert_int_equal(done.status, 0);
    assert_says(done.err, "glint replay: with --circuit-dir's Verilog; the packet was made with");
    forget(&done);

    done = own_run(MAC, "", "verify --exhaustive --width 4 --rtl %s --out %s", wrong,
                   scratch_path("exhaustive"));
    assert_int_equal(done.status, 1);
    assert_says(done.out, "out_s");
    forget(&done);
}

static void the_waveform_and_its_save_file_are_written(void **state)
{
    (void)state;
    outcome done = own_run(MAC, "", "wave --out %s", scratch_path("wave"));
    assert_outcome(&done, 0, NULL);
    forget(&done);
    char *save = scratch_read(scratch_path("wave/saturating_mac_8.gtkw"), NULL);
    assert_says(save, "Stage 1: the product");
    assert_says(save, "product");
    free(save);
    assert_int_equal(access(scratch_path("wave/saturating_mac_8.fst"), R_OK), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_it_is_taken_for_is_told),
        cmocka_unit_test(it_is_verified),
        cmocka_unit_test(every_input_is_tried),
        cmocka_unit_test(eval_has_the_right_numbers),
        cmocka_unit_test(a_fault_is_found_looked_at_and_played_again),
        cmocka_unit_test(the_waveform_and_its_save_file_are_written),
    };
    return cmocka_run_group_tests_name("example", tests, scratch_make, scratch_remove);
}
