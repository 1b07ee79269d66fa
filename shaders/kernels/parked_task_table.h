// A task of a lane as it is kept between two dispatches of the same tiles, as
// shared/declare_structs.h says.
STRUCT(ParkedTask)
#include "path/path_fields.h"
FIELD(uint, nextItem, w) ///< the tile's next pixel; 0 if the tile starts from the beginning
ROW(uint, item, x)       ///< the task's pixel, in the order of the tile
FIELD(uint, hasPath, y)  ///< 1 where the fields above are a path, else 0
FIELD(uint, pad0, z)
FIELD(uint, pad1, w)
END(ParkedTask)

#undef STRUCT
#undef ROW
#undef FIELD
#undef END
