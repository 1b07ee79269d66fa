// Included before a table of structs (see shared/declare_structs.h): the table then defines put(X),
// which puts each field of struct X in the order of its declaration. No include guard: each table
// needs it again.
#define STRUCT(name) void put(name fields) {
#define ROW(type, name, words) put(fields.name);
#define FIELD(type, name, words) put(fields.name);
#define END(name) }
