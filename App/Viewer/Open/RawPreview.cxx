#include "Viewer/Open/RawPreview.h"

#include "Scene/RawGuess.h"
#include "Scene/VolumeLoading.h"
#include "Viewer/Open/GrayImage.h"

#include <QtConcurrent/QtConcurrentRun>

#include <exception>
#include <utility>

namespace varimarch
{

namespace
{

// Runs in the other thread.
QImage ReadSlice(const FileSource& slice, const std::atomic<bool>* stop)
{
  try
  {
    const LoadedVolume volume = LoadVolume(slice, [stop](double) { return !*stop; });
    return ImageOf(MiddleSlice(volume.image));
  }
  catch (const std::exception&)
  {
    return {};
  }
}

}

RawPreview::RawPreview(QObject* parent)
  : QObject(parent)
{
  connect(&this->watcher, &QFutureWatcher<QImage>::finished, this, &RawPreview::Finish);
}

RawPreview::~RawPreview()
{
  this->watcher.disconnect(this);
  this->stop = true;
  this->watcher.waitForFinished();
}

void RawPreview::Read(const std::string& path, const RawLayout& layout, int slice)
{
  // Read the slice as a volume of its own, with the slices before it as part of the header.
  RawLayout single = layout;
  single.dimensions[2] = 1;
  const std::int64_t sliceBytes = BytesOf(single) - single.headerBytes;
  single.headerBytes += slice * sliceBytes;
  this->wanted = FileSource{ path, single };
  this->stop = true;
  if (!this->watcher.isRunning())
  {
    this->Start();
  }
}

void RawPreview::Start()
{
  this->stop = false;
  this->watcher.setFuture(
    QtConcurrent::run(ReadSlice, *std::exchange(this->wanted, std::nullopt), &this->stop));
}

void RawPreview::Finish()
{
  if (this->wanted)
  {
    this->Start();
  }
  else
  {
    emit this->Ready(this->watcher.result());
  }
}

}
