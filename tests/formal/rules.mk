# Proofs by yosys-smtbmc and z3 (docs/formal.md). FORMAL_PROOFS are proofs as tests/formal/prove.sh names
# them; FORMAL_FAULTS wrong circuits that the prover must notice, PROOF:PROPERTY:FAULT, each property of
# each kind of proof at least once.

FORMAL := $(BUILD)/formal

# Lanes, and which lane: every one of each number of lanes.
FORMAL_LANES  := $(foreach l,$(LANE_COUNTS),\
    $(foreach i,$(wordlist 1,$l,0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15),$l-$i))
FORMAL_PROOFS := roms \
    $(foreach l,$(FORMAL_LANES),$(foreach p,$(PIPELINES),\
        $(foreach g,$(GATES),device-$g-$p-$l) gates-$p-$l)) \
    $(foreach n,$(DIVIDER_SHIFTS),table-$n sequential-$n pipelined-$n)

FORMAL_FAULTS := \
    device-cosine-pipelined-1-0:uninvited:tests/formal/wrong/reset_leaves_valid/specular_device.sed \
    device-cosine-pipelined-1-0:in_order:tests/lockstep/wrong/silent/specular_device.sed \
    device-cosine-pipelined-1-0:once:tests/formal/wrong/twice/specular_device.sed \
    device-cosine-pipelined-1-0:frozen:tests/formal/wrong/unfrozen/specular_lane.sed \
    device-cosine-pipelined-1-0:value:tests/lockstep/wrong/unstallable/specular_lane.sed \
    device-cosine-pipelined-1-0:value:tests/formal/wrong/other_n/specular_device.sed \
    device-cosine-combinational-1-0:value:tests/lockstep/wrong/truncating/color_multiplier.sed \
    device-cosine-combinational-16-7:value:tests/formal/wrong/swapped_lanes/specular_device.sed \
    gates-pipelined-1-0:gates_equal:tests/formal/wrong/wrong_sign/specular_lane.sed \
    roms:sigma:tests/lockstep/wrong/sigma_off_by_one/sigma_rom.sed \
    roms:range:tests/formal/wrong/sigma_over_range/sigma_rom.sed \
    roms:limit:tests/lockstep/wrong/late_limit/limit_rom.sed \
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

formal_parts  = $(subst :, ,$1)
formal_search = $(FORMAL)/$(subst :,-,$(word 1,$(formal_parts)):$(word 2,$(formal_parts)):$(call wrong_name,$1))
FORMAL_DIRS  := $(FORMAL_PROOFS:%=$(FORMAL)/%) $(foreach f,$(FORMAL_FAULTS),$(call formal_search,$f))
FORMAL_FILES := $(RTL) $(wildcard tests/formal/*.v tests/formal/*.smtc) tests/formal/prove.sh

# "proved" is there only after a success; the line "result" in any case.
$(FORMAL_PROOFS:%=$(FORMAL)/%/proved): $(FORMAL)/%/proved: $(FORMAL_FILES)
	tests/formal/prove.sh $(@D) $*
	@touch $@

define formal_search_rule
$(call formal_search,$1)/proved: $(FORMAL_FILES) $(word 3,$(formal_parts))
	tests/formal/prove.sh $$(@D) $(word 1,$(formal_parts)) $(word 3,$(formal_parts)) $(word 2,$(formal_parts))
	@touch $$@
endef
$(foreach f,$(FORMAL_FAULTS),$(eval $(call formal_search_rule,$f)))

.PHONY: formal formal-proofs
formal-proofs: $(FORMAL_DIRS:%=%/proved)

formal:
	sim/deps.sh formal
	+$(MAKE) -k -j$(JOBS) formal-proofs; made=$$?; tests/formal/report.sh $(FORMAL_DIRS) && exit $$made
