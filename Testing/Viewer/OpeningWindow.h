#ifndef Varimarch_Testing_OpeningWindow_h
#define Varimarch_Testing_OpeningWindow_h

#include "Module/Files/PhantomFiles.h"
#include "Viewer/MainWindow.h"
#include "Waiting.h"

#include <QTest>

#include <gtest/gtest.h>

#include <string>

namespace varimarch
{

/// A window that opens the files of a folder.
class OpeningWindow : public testing::Test
{
protected:
  OpeningWindow() { this->window.show(); }

  /// Writes an even series that was compressed with loss to the folder "DOE^JANE".
  void WriteSeries(const std::string& uid, int sliceCount)
  {
    DicomOptions options;
    options.seriesUid = uid;
    options.lossy = true;
    for (int slice = 0; slice < sliceCount; ++slice)
    {
      this->folder.Write("DOE^JANE/" + uid + "-" + std::to_string(slice),
        DicomBytes(phantom::Stored(0), slice, options));
    }
  }

  void Open(const std::string& name)
  {
    this->window.Open(QString::fromStdString(this->folder.Path(name)));
  }

  bool IsOpened()
  {
    return QTest::qWaitFor(
      [this] { return this->window.Model()->CurrentStudy() != nullptr; }, MostMilliseconds);
  }

  TemporaryFolder folder;
  MainWindow window;
};

}

#endif
