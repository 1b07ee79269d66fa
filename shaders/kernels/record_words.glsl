// The fields of a record as words of 32 bits, one after the other, without padding.
#ifndef CALOTYPE_KERNELS_RECORD_WORDS_GLSL
#define CALOTYPE_KERNELS_RECORD_WORDS_GLSL

/// Up to three words of one value.
struct RecordWords {
    uvec3 words;
    uint count;
};

RecordWords recordWords(uint value) { return RecordWords(uvec3(value, 0u, 0u), 1u); }
RecordWords recordWords(float value) { return recordWords(floatBitsToUint(value)); }
RecordWords recordWords(vec2 value) { return RecordWords(uvec3(floatBitsToUint(value), 0u), 2u); }
RecordWords recordWords(vec3 value) { return RecordWords(floatBitsToUint(value), 3u); }

/// Writes a value to `buffer` from `place` on, and moves `place` behind it.
#define PUT_WORDS(buffer, place, value)                                                            \
    {                                                                                              \
        RecordWords put = recordWords(value);                                                      \
        for (uint i = 0u; i < put.count; ++i)                                                      \
            buffer[place + i] = put.words[i];                                                      \
        place += put.count;                                                                        \
    }

#endif
