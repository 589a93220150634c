#include "Archive/Multipart.h"

#include <stdexcept>

namespace varimarch
{

namespace
{

// The longest header of a part, and text before the first.
constexpr int MostHeaderBytes = 65536;

// RFC 2046 allows 70 characters, but Orthanc takes 73.
constexpr int LongestBoundary = 200;

// Space that a file takes on a disk besides its bytes, about: a part may be empty.
constexpr double BytesPerFile = 4096.0;

}

QByteArray BoundaryOf(const QByteArray& contentType)
{
  if (!contentType.trimmed().toLower().startsWith("multipart/related"))
  {
    return {};
  }
  const int name = contentType.toLower().indexOf("boundary=");
  QByteArray text = name < 0 ? QByteArray() : contentType.mid(name + 9);
  text = text.startsWith('"') ? text.split('"')[1] : text.split(';').first().trimmed();
  return text.size() <= LongestBoundary ? text : QByteArray();
}

MultipartWriter::MultipartWriter(
  const QByteArray& boundary, const std::string& folder, double spaceBytes)
  : delimiter("\r\n--" + boundary)
  , folder(folder)
  , spaceBytes(spaceBytes)
  , buffer("\r\n") // the first boundary may lack the line break before it
{
}

void MultipartWriter::Add(const QByteArray& bytes)
{
  this->buffer += bytes;
  while (this->Step())
  {
  }
}

// Returns false if more bytes are needed.
bool MultipartWriter::Step()
{
  switch (this->state)
  {
    case State::Preamble:
      return this->SkipTo(this->delimiter, State::AfterBoundary);
    case State::AfterBoundary:
      return this->TakeBoundaryEnd();
    case State::Header:
      return this->SkipTo("\r\n\r\n", State::Body);
    case State::Body:
      return this->TakeBody();
    case State::End:
      this->buffer.clear();
  }
  return false;
}

bool MultipartWriter::SkipTo(const QByteArray& mark, State next)
{
  const int place = this->buffer.indexOf(mark);
  if (place < 0)
  {
    if (this->buffer.size() > MostHeaderBytes)
    {
      throw std::runtime_error("an answer that is not in parts as it says");
    }
    return false;
  }
  this->buffer.remove(0, place + mark.size());
  this->state = next;
  if (next == State::Body)
  {
    this->BeginPart();
  }
  return true;
}

// Two hyphens end the message. Otherwise the line break stays, since a part may have no header.
bool MultipartWriter::TakeBoundaryEnd()
{
  if (this->buffer.size() < 2)
  {
    return false;
  }
  this->state = this->buffer.startsWith("--") ? State::End : State::Header;
  return true;
}

void MultipartWriter::BeginPart()
{
  this->TakeSpace(BytesPerFile);
  ++this->partCount;
  this->part = std::make_unique<QFile>(
    QString::fromStdString(this->folder) + QStringLiteral("/image-%1.dcm").arg(this->partCount));
  if (!this->part->open(QIODevice::WriteOnly | QIODevice::NewOnly))
  {
    throw std::runtime_error("no place for an image: " + this->part->errorString().toStdString());
  }
}

bool MultipartWriter::TakeBody()
{
  const int place = this->buffer.indexOf(this->delimiter);
  // A part of the delimiter may have come already.
  this->Write(place >= 0 ? place : this->buffer.size() - this->delimiter.size());
  if (place < 0)
  {
    return false;
  }
  this->buffer.remove(0, this->delimiter.size());
  this->part.reset();
  this->state = State::AfterBoundary;
  return true;
}

void MultipartWriter::TakeSpace(double bytes)
{
  this->spaceBytes -= bytes;
  if (this->spaceBytes < 0.0)
  {
    throw std::runtime_error("more bytes of images than there is free space for");
  }
}

void MultipartWriter::Write(int count)
{
  if (count <= 0)
  {
    return;
  }
  this->TakeSpace(count);
  if (this->part->write(this->buffer.constData(), count) != count || !this->part->flush())
  {
    throw std::runtime_error("no place for an image: " + this->part->errorString().toStdString());
  }
  this->buffer.remove(0, count);
}

void MultipartWriter::Finish() const
{
  if (this->state != State::End)
  {
    throw std::runtime_error("an answer that ends early");
  }
}

}
