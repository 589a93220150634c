#ifndef Varimarch_Archive_Multipart_h
#define Varimarch_Archive_Multipart_h

#include <QByteArray>
#include <QFile>

#include <memory>
#include <string>

namespace varimarch
{

/// The boundary that a header Content-Type of multipart/related names; empty for other types.
QByteArray BoundaryOf(const QByteArray& contentType);

/// Writes the parts of a multipart message (RFC 2046 5.1) into files, as the bytes come. The
/// message may be damaged or forged: names in it are ignored, and its size is limited.
class MultipartWriter
{
public:
  /// @param folder      gets the files "image-1.dcm" and so on
  /// @param spaceBytes  the most bytes that all files may take
  MultipartWriter(const QByteArray& boundary, const std::string& folder, double spaceBytes);

  /// @throws std::runtime_error with the part of a sentence that says what is wrong
  void Add(const QByteArray& bytes);

  /// Ends the message.
  /// @throws std::runtime_error if it is not complete
  void Finish() const;

  int PartCount() const { return this->partCount; }

private:
  enum class State
  {
    Preamble,
    AfterBoundary,
    Header,
    Body,
    End,
  };

  bool Step();
  bool SkipTo(const QByteArray& mark, State next);
  bool TakeBoundaryEnd();
  bool TakeBody();
  void BeginPart();
  void TakeSpace(double bytes);
  void Write(int count);

  QByteArray delimiter; ///< the boundary with the line break before it, which belongs to it
  std::string folder;
  double spaceBytes;
  State state = State::Preamble;
  QByteArray buffer;
  std::unique_ptr<QFile> part;
  int partCount = 0;
};

}

#endif
