#include "Readers/Decoder/Jobs.h"

namespace varimarch
{

const char* DecoderVersion()
{
  return VARIMARCH_VERSION;
}

}
