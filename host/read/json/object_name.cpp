#include "read/json/object_name.h"

#include "read/json/type.h"

namespace calotype {

JsonKey objectNameKey() {
    return {"name", textType(),
            "The object's name in mattes (--aov cryptoObject), by default its type and its index, "
            "such as sphere 3 or light 0. Shapes of one name are one object."};
}

std::string readObjectName(const JsonObject& object, const std::string& kind, size_t index) {
    const auto name = object.optional("name");
    if (!name)
        return kind + " " + std::to_string(index);
    if (name->text().empty())
        name->fail("is empty; give the object a name, or leave the key out");
    return name->text();
}

} // namespace calotype
