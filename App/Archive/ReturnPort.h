#ifndef Varimarch_Archive_ReturnPort_h
#define Varimarch_Archive_ReturnPort_h

#include "Archive/Association.h"

#include <memory>
#include <string>
#include <thread>

class DcmTransportLayer;

namespace varimarch
{

/// A port at which images arrive that C-MOVE has asked for, as long as this object lives. It takes
/// images only from a program with the title of the archive, for our own title. If the archive is
/// reached by TLS, it must use TLS here too, with a certificate that we trust for it.
class ReturnPort
{
public:
  /// @param progress  counts the images; must outlive this object
  /// @throws std::runtime_error with a sentence if the port is in use, or our certificate is unfit
  ReturnPort(const ArchiveAddress& address, DimseProgress& progress);
  ~ReturnPort();
  ReturnPort(const ReturnPort&) = delete;
  void operator=(const ReturnPort&) = delete;

private:
  class Receiver;

  std::unique_ptr<DcmTransportLayer> encryption; ///< null without TLS; must outlive the receiver
  std::unique_ptr<Receiver> receiver;
  std::thread thread;
};

}

#endif
