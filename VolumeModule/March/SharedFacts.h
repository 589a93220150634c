#ifndef Varimarch_March_SharedFacts_h
#define Varimarch_March_SharedFacts_h

#include "March/SearchFacts.h"

#include <limits>
#include <vector>

namespace varimarch
{

// Facts that several processes share as numbers. They are merged by taking the least of each
// number; one of which the greatest counts is negative there.

/// The numbers of a process that draws no part.
constexpr double NumberOfNoPart = std::numeric_limits<double>::infinity();

/// The number of a condition that one part suffices for.
inline double IfAny(bool holds)
{
  return holds ? -1.0 : 0.0;
}

inline bool HoldsForAny(double least)
{
  return least < 0.0;
}

std::vector<double> NumbersOf(const SearchFacts& facts);

/// @param numbers  as many as NumbersOf returns, or more
SearchFacts FactsOf(const std::vector<double>& numbers);

}

#endif
