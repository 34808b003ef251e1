/* The table of ports that the shim is compiled with: glint_ports.h, see shim.cpp. */
#ifndef GLINT_SIM_RTL_TABLE_H
#define GLINT_SIM_RTL_TABLE_H

#include "rtl/product.h"

/* Writes it into a directory, where Verilator has left the header of its class. GLINT_DEVICE_FAULT,
 * naming it, when a port is called as a function of that class is. */
glint_status glint_table_write(const glint_product *product, const char *directory,
                               glint_error *err);

#endif
