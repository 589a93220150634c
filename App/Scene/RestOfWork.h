#ifndef Varimarch_Scene_RestOfWork_h
#define Varimarch_Scene_RestOfWork_h

#include <string>

namespace varimarch
{

/// The time that the rest of some work takes if it goes on as it did: ", about 7 minutes left", or
/// hours. Empty in the first seconds, and if it is less than a minute.
/// @param part  the finished part, [0, 1]; 0 if it is not known
std::string RestOfWork(double part, double elapsedSeconds);

}

#endif
