#ifndef Varimarch_Core_Blocks_Runs_h
#define Varimarch_Core_Blocks_Runs_h

#include <cstddef>

namespace varimarch
{

/// Calls take(first, number behind the last, kind) for each run of numbers below `count` that are
/// of one kind.
template <class KindOf, class Take>
void EachRun(std::size_t count, KindOf kindOf, Take take)
{
  for (std::size_t begin = 0; begin < count;)
  {
    const auto kind = kindOf(begin);
    std::size_t end = begin + 1;
    while (end < count && kindOf(end) == kind)
    {
      ++end;
    }
    take(begin, end, kind);
    begin = end;
  }
}

}

#endif
