#ifndef Varimarch_Readers_DifferentialStream_h
#define Varimarch_Readers_DifferentialStream_h

#include <string>

namespace varimarch
{

/// True if the bytes begin like a differential data stream (DDS) of the V^3 package.
bool IsDifferentialStream(const std::string& bytes);

/// Decodes a differential data stream: differences to the byte before and to the row before, with
/// as many bits as each run of them needs. The method is Stefan Roettger's,
/// http://www.stereofx.org.
/// @param path  path for the error message
/// @throws std::runtime_error if the stream ends early
std::string DecodedDifferentialStream(const std::string& path, const std::string& bytes);

}

#endif
