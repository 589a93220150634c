#ifndef Varimarch_Archive_ReturnPort_h
#define Varimarch_Archive_ReturnPort_h

#include "Archive/Association.h"

#include <memory>
#include <string>
#include <thread>

namespace varimarch
{

/// A port at which images arrive that C-MOVE has asked for, as long as this object lives. It takes
/// images only from a program with the title of the archive, for our own title.
class ReturnPort
{
public:
  /// @param progress  counts the images; must outlive this object
  /// @throws std::runtime_error with a sentence if the port is in use
  ReturnPort(const ArchiveAddress& address, DimseProgress& progress);
  ~ReturnPort();
  ReturnPort(const ReturnPort&) = delete;
  void operator=(const ReturnPort&) = delete;

private:
  class Receiver;

  std::unique_ptr<Receiver> receiver;
  std::thread thread;
};

}

#endif
