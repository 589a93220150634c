#include "Readers/Decoder/DecoderSession.h"

#include <algorithm>

namespace varimarch
{
namespace
{

thread_local DecoderSession* current = nullptr;

}

DecoderSession::DecoderSession(double longestSilence)
  : outer(current)
  , longestSilence(longestSilence)
{
  current = this;
}

DecoderSession::~DecoderSession()
{
  current = this->outer;
  if (this->outer && this->idle)
  {
    this->outer->Return(std::move(this->idle));
  }
}

DecoderSession* DecoderSession::Current()
{
  return current;
}

std::unique_ptr<DecoderProcess> DecoderSession::Idle()
{
  if (!this->idle && this->outer)
  {
    return this->outer->Idle();
  }
  return this->idle ? std::move(this->idle) : std::make_unique<DecoderProcess>();
}

void DecoderSession::LosePatience()
{
  constexpr double Least = 5.0;
  this->longestSilence =
    std::max(0.5 * this->longestSilence, std::min(Least, this->longestSilence));
}

}
