// Conversions between the words of a 16-byte row and the fields of structs, for code that is made
// from tables of structs (shared/declare_structs.h).
#ifndef CALOTYPE_BUFFERS_ROW_WORDS_GLSL
#define CALOTYPE_BUFFERS_ROW_WORDS_GLSL

// The words as a field of the type.
#define WORDS_AS_uint(words) words
#define WORDS_AS_uvec2(words) words
#define WORDS_AS_float(words) uintBitsToFloat(words)
#define WORDS_AS_vec2(words) uintBitsToFloat(words)
#define WORDS_AS_vec3(words) uintBitsToFloat(words)

// A field as words.
uint wordsOf(uint field) { return field; }
uint wordsOf(float field) { return floatBitsToUint(field); }
uvec3 wordsOf(vec3 field) { return floatBitsToUint(field); }

#endif
