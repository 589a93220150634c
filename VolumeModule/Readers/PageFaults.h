#ifndef Varimarch_Readers_PageFaults_h
#define Varimarch_Readers_PageFaults_h

#include <cstddef>
#include <optional>
#include <string>

namespace varimarch
{

/// Addresses whose pages a thread of this process provides when another touches them, by Linux's
/// userfaultfd(2). A thread that touches a page which is not there waits until it is put there.
///
/// Pages of Put() report their first write, those of PutZeros() do not. The addresses are missing
/// in a process that is forked. System calls that are given addresses whose page is not there fail,
/// unless the user may let them wait (vm.unprivileged_userfaultfd).
class PageFaults
{
public:
  /// The reason why this cannot be had here, as the rest of a sentence; empty if it can.
  static const std::string& Obstacle();

  /// @param pages  anonymous memory of this process, to be unmapped after this object's end
  /// @throws std::runtime_error if the system refuses
  PageFaults(char* pages, std::size_t byteCount);
  ~PageFaults();
  PageFaults(const PageFaults&) = delete;
  PageFaults& operator=(const PageFaults&) = delete;

  struct Fault
  {
    char* page;
    bool isFirstWrite; ///< true if the page is there, and somebody waits to write to it
  };

  /// Waits for the next fault; none after Stop().
  std::optional<Fault> Next();
  void Stop();

  /// Puts pages at their place, and lets those go on who wait for them.
  /// @param byteCount  whole pages
  void Put(char* pages, const char* bytes, std::size_t byteCount);

  /// Puts pages of zeros, which take no memory until they are written.
  void PutZeros(char* pages, std::size_t byteCount);

  /// Lets those go on who wait for a page that is there.
  void Wake(char* page);
  void AllowWriting(char* page);

private:
  int faults;
  int stop;
};

}

#endif
