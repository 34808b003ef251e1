# What is checked of the dividers beyond what every listed setting gets (tests/circuits.mk); the
# lists are those of specular.mk.

MUTATED       += divider_sequential_12 divider_pipelined_12
# A small one for make test, which is not to wait long.
MUTATED_SHORT += divider_sequential_6
# It takes 13 clocks for each of the 131 072 divisions of its sweep: only the first 30 769 of them.
SWEEP_CLOCKS_divider_sequential_12 := 400000

OPINIONS_DIVIDER := $(foreach f,sequential pipelined,$(foreach n,6 12 16,divider_$f_$n))
OPINIONS         += $(foreach b,ice40 generic nodfg plain,$(OPINIONS_DIVIDER:%=$b/%)) \
                    $(foreach f,sequential pipelined,\
                        $(foreach w,$(wildcard tests/divider/wrong/$f/*/*.sed),\
                            generic-divider_$(call fault_name,$w)/divider_$f_12))
OPINIONS_SHORT   += generic/divider_sequential_12 ice40/divider_pipelined_6 \
                    plain/divider_sequential_12 generic-divider_late_done/divider_sequential_12 \
                    generic-divider_unsigned_stage/divider_pipelined_12

COVERED += $(foreach n,6 7 8 9 10 11 12 13 14 15 16,divider_sequential_$n) \
           $(foreach n,6 12 16,divider_pipelined_$n)

FORMAL_FAULTS += \
    table-12:rounded:tests/divider/wrong/pipelined/table_off_by_one/reciprocal_rom.sed \
    table-12:miss:tests/formal/wrong/zero_in_table/reciprocal_rom.sed \
    sequential-12:busy:tests/divider/wrong/sequential/restarting/shift_divider.sed \
    sequential-12:done:tests/divider/wrong/sequential/late_done/shift_divider.sed \
    sequential-12:once:tests/formal/wrong/done_stays/shift_divider.sed \
    sequential-12:sum:tests/divider/wrong/sequential/logical_shift/shift_divider.sed \
    sequential-12:out_of_table:tests/formal/wrong/silent_miss/shift_divider.sed \
    sequential-12:cleared:tests/formal/wrong/reset_leaves_sum/shift_divider.sed \
    sequential-12:frozen:tests/formal/wrong/running_on/shift_divider.sed \
    pipelined-6:uninvited:tests/formal/wrong/stage_leaves_valid/divider_stage.sed \
    pipelined-6:in_order:tests/formal/wrong/every_other/pipelined_divider.sed \
    pipelined-6:once:tests/formal/wrong/every_other/pipelined_divider.sed \
    pipelined-6:frozen:tests/formal/wrong/stage_runs_on/divider_stage.sed \
    pipelined-6:sum:tests/formal/wrong/other_k/pipelined_divider.sed \
    pipelined-6:sum:tests/divider/wrong/pipelined/unsigned_stage/divider_stage.sed \
    pipelined-6:out_of_table:tests/formal/wrong/stage_forgets_miss/divider_stage.sed
