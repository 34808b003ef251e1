# The shaders by glslang, another compiler than the driver's.

.PHONY: lint-shaders
lint-shaders:
	$(call say,LINT,sim/shader)
	$Qtests/shader/lint.sh $(BUILD)/lint/shader
