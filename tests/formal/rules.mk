# Proofs by yosys-smtbmc and z3 (docs/formal.md): those of tests/formal/proofs.sh, and
# FORMAL_FAULTS, wrong circuits that the prover must notice (tests/circuits/*.mk).

FORMAL := $(BUILD)/formal

formal_parts  = $(subst :, ,$1)
formal_pair   = $(word 1,$(formal_parts))-$(word 2,$(formal_parts))
formal_search = $(FORMAL)/$(formal_pair)-$(call fault_name,$1)
FORMAL_SEARCHES := $(foreach f,$(FORMAL_FAULTS),$(call formal_search,$f))
FORMAL_FILES := $(RTL) $(wildcard tests/formal/*.v tests/formal/*.smtc) tests/formal/prove.sh

# "proved" is there only after a success; the line "result" in any case.
$(FORMAL)/%/proved: $(FORMAL_FILES)
	tests/formal/prove.sh $(@D) $*
	@touch $@

define formal_search_rule
$(call formal_search,$1)/proved: $(FORMAL_FILES) $(word 3,$(formal_parts))
	tests/formal/prove.sh $$(@D) $(word 1,$(formal_parts)) \
	    $(word 3,$(formal_parts)) $(word 2,$(formal_parts))
	@touch $$@
endef
$(foreach f,$(FORMAL_FAULTS),$(eval $(call formal_search_rule,$f)))

# In a recipe: what all of them are, each a directory.
FORMAL_DIRS = $$(tests/formal/proofs.sh $(BUILD)/settings | sed 's:^:$(FORMAL)/:') \
    $(FORMAL_SEARCHES)

.PHONY: formal formal-proofs
formal-proofs: $(BUILD)/settings
	+@$(MAKE) -k $$(printf '%s/proved ' $(FORMAL_DIRS))

formal:
	sim/deps.sh formal
	+$(MAKE) $(BUILD)/settings
	+$(MAKE) -k $(PARALLEL) formal-proofs; made=$$?; \
	    tests/formal/report.sh $(FORMAL_DIRS) && exit $$made

# tests/formal/test_formal.c reads it.
build-tests: $(BUILD)/settings
