#include "read/load_context.h"

#include "check/validate.h"

namespace calotype {

Scene LoadContext::finish() && {
    if (options.size) {
        scene.film.width = options.size->width;
        scene.film.height = options.size->height;
    }
    validate(scene, warnings);
    scene.warnings = warnings.sentences();
    scene.hash = hash.value();
    return std::move(scene);
}

} // namespace calotype
