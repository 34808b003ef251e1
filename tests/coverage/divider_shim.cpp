// The shim of sim/rtl over a divider that counts its lines and toggles: its table,
// GLINT_COUNTING_TABLE, is the other with one function more to do at the end.
#include "../../sim/rtl/divider_shim.cpp"

#include "counters.hpp"

#define NAME_OF(name) STRING_OF(name)

namespace
{
glint_divider_model counting(glint_divider_model model)
{
    model.destroy = [](void *instance) {
        write_counters(as_instance(instance), NAME_OF(GLINT_COUNTING_NAME));
        destroy(instance);
    };
    return model;
}
} // namespace

extern "C" const glint_divider_model GLINT_COUNTING_TABLE;
const glint_divider_model GLINT_COUNTING_TABLE = counting(GLINT_MODEL_TABLE);
