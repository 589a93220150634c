#ifndef Varimarch_Testing_RandomNumbers_h
#define Varimarch_Testing_RandomNumbers_h

#include <cstdlib>
#include <random>
#include <vector>

/// Choices of tests that act at random. The same seed makes the same choices.
using Random = std::mt19937;

inline double Between(Random& random, double lowest, double highest)
{
  return std::uniform_real_distribution<double>(lowest, highest)(random);
}

/// A whole number from 0 to count - 1.
inline int Below(Random& random, int count)
{
  return std::uniform_int_distribution<int>(0, count - 1)(random);
}

template <class Value>
Value OneOf(Random& random, const std::vector<Value>& values)
{
  return values[Below(random, int(values.size()))];
}

/// The number in an environment variable, by which a longer or another run is asked for.
inline int NumberFromEnvironment(const char* name, int otherwise)
{
  const char* const text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

#endif
