#ifndef Varimarch_Testing_Waiting_h
#define Varimarch_Testing_Waiting_h

namespace varimarch
{

/// A test waits at most this long for work that another thread does.
inline constexpr int MostMilliseconds = 60000;

}

#endif
