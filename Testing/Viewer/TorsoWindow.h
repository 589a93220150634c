#ifndef Varimarch_Testing_TorsoWindow_h
#define Varimarch_Testing_TorsoWindow_h

#include "Viewer/MainWindow.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/VolumeView.h"
#include "Waiting.h"

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

#include <vtkXMLImageDataWriter.h>

#include <gtest/gtest.h>

namespace varimarch
{

/// A window beside the file of a small torso.
class Window : public testing::Test
{
protected:
  Window()
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(
      LoadVolume(ProceduralSource{ ProceduralKind::Torso, { 32, 28, 20 }, 1 }).image);
    writer->SetFileName(this->Path("torso.vti").toUtf8());
    writer->Write();
    this->window.resize(900, 500);
    this->window.show();
  }

  QString Path(const QString& name) const { return this->folder.filePath(name); }

  VolumeView* View() { return this->window.CentralView()->Ours(); }
  VolumeSurface* Surface() { return this->View()->findChild<VolumeSurface*>(); }
  SceneModel* Model() { return this->window.Model(); }

  /// Opens the torso and waits for its first frame.
  void OpenTorso()
  {
    this->window.Open(this->Path("torso.vti"));
    QSignalSpy drawn(this->View(), &VolumeView::Drawn);
    ASSERT_TRUE(QTest::qWaitFor(
      [&] { return this->Model()->CurrentStudy() && !drawn.isEmpty(); }, MostMilliseconds));
  }

  void Drop(const QStringList& paths)
  {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths)
    {
      urls << QUrl::fromLocalFile(path);
    }
    data.setUrls(urls);
    QDragEnterEvent enter({ 10, 10 }, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&this->window, &enter);
    QDropEvent drop({ 10.0, 10.0 }, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&this->window, &drop);
  }

  QTemporaryDir folder;
  MainWindow window;
};

}

#endif
