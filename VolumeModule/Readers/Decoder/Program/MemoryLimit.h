#ifndef Varimarch_Readers_Decoder_Program_MemoryLimit_h
#define Varimarch_Readers_Decoder_Program_MemoryLimit_h

namespace varimarch
{

/// Lets this process take this much more memory than it had at the first call [bytes]; more is
/// refused.
void LimitMemory(double bytes);

}

#endif
