#ifndef Varimarch_Readers_Decoder_Program_PerformJob_h
#define Varimarch_Readers_Decoder_Program_PerformJob_h

#include "Readers/Decoder/Program/Replies.h"

#include <string>

namespace varimarch
{

/// Performs a job, and sends its result.
/// @throws std::exception if the job fails
/// @throws ReadCancelled if the reader wants no more of it
void PerformJob(const std::string& job, Replies& replies);

}

#endif
