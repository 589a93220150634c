#ifndef Varimarch_Testing_Dice_h
#define Varimarch_Testing_Dice_h

#include "Benchmarks/Stages/Dice.h"

#include <cstdlib>

using varimarch::Dice;

/// The number in an environment variable, by which a longer or another run is asked for.
inline long NumberFromEnvironment(const char* variable, long otherwise)
{
  const char* const text = std::getenv(variable);
  return text ? std::strtol(text, nullptr, 10) : otherwise;
}

#endif
