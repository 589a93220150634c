#ifndef Varimarch_Readers_Memory_h
#define Varimarch_Readers_Memory_h

#include <cstdint>

namespace varimarch
{

struct ReadOptions;

/// Main memory of the machine [bytes].
double PhysicalMemoryBytes();

/// Memory that a reader's options let the program use [bytes].
std::uint64_t MostMemoryBytes(const ReadOptions& options);

/// Main memory that programs may still take [bytes].
double FreeMemoryBytes();

}

#endif
