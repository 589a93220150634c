#ifndef Varimarch_Readers_Memory_h
#define Varimarch_Readers_Memory_h

namespace varimarch
{

/// Main memory of the machine [bytes].
double PhysicalMemoryBytes();

/// Main memory that programs may still take [bytes].
double FreeMemoryBytes();

}

#endif
