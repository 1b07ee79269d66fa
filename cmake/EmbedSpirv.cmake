# cmake -DMODULE=x.spv -DVARIABLE=kName -DHEADER=x.spv.h -P EmbedSpirv.cmake: the module's words, as
# a C++ array.
file(READ ${MODULE} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}")
file(WRITE ${HEADER}
     "#pragma once\n\n#include <cstdint>\n\nconst uint32_t ${VARIABLE}[] = {${words}};\n")
