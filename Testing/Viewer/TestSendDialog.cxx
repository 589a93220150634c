// An image is sent to an archive from the window, with or without the patient.

#include "FakeWebArchive.h"
#include "Module/Files/PhantomDicom.h"
#include "Module/Files/PhantomFiles.h"
#include "ScanOfPatient.h"
#include "Scene/Volumes/Placing.h"
#include "Viewer/Archives/ArchiveChoice.h"
#include "Viewer/Archives/SendDialog.h"
#include "Viewer/MainWindow.h"
#include "Waiting.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Sending : public testing::Test
{
protected:
  Sending()
  {
    QSettings().clear();
    KeepAsHospital(this->server.Url());
    this->server.Answer("/studies", "application/dicom+json", "{}");
    this->window.show();
  }

  void OpenScan()
  {
    for (int slice = 0; slice < 3; ++slice)
    {
      phantom_dicom::Elements elements = phantom_dicom::SliceElements(phantom::Stored(0), slice);
      elements[0x00200052] = phantom_dicom::Text("UI", "1.2.52"); // frame of reference
      this->scans.Write("scan/" + std::to_string(slice), phantom_dicom::FileBytes(elements));
    }
    this->window.Open(QString::fromStdString(this->scans.Path("scan")));
    ASSERT_TRUE(QTest::qWaitFor(
      [this] { return this->window.Model()->CurrentStudy() != nullptr; }, MostMilliseconds));
  }

  // Lays another study over the scan. It is then the one whose look is edited.
  void AddScanOfOther()
  {
    WriteScanOfPatient(this->otherScans);
    const FileSource source = { this->otherScans.Path(""), std::nullopt };
    LoadedVolume volume = LoadVolume(source);
    ImageStatistics statistics(volume.image);
    const auto study = std::make_shared<const Study>(Study{ volume, statistics });
    this->window.Model()->AddOverlay(OverlayOf(source, volume, statistics), study, "add a scan");
  }

  void MeasureDistance()
  {
    this->window.Model()->Edit(ScenePart::Measures, "measure",
      [](Scene& scene) {
        scene.measures.push_back({ MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } } });
      });
  }

  // Sends the image, and the measurements if that is possible. Returns the last file that was sent.
  QByteArray Sent(bool withIdentity)
  {
    this->window.findChild<QAction*>("sendImage")->trigger();
    auto* const dialog = this->window.findChild<SendDialog*>();
    dialog->findChild<QCheckBox*>("identity")->setChecked(withIdentity);
    dialog->findChild<QCheckBox*>("report")->click(); // does nothing if it is disabled
    dialog->findChild<QPushButton*>("sendImage")->click();
    auto* const status = dialog->findChild<QLabel*>("status");
    EXPECT_TRUE(QTest::qWaitFor(
      [&] { return status->text() == "The archive has stored the image."; }, MostMilliseconds))
      << status->text().toStdString();
    delete dialog;
    return this->server.lastBody;
  }

  TemporaryFolder scans;
  TemporaryFolder otherScans;
  FakeWebArchive server;
  MainWindow window;
};

}

TEST_F(Sending, NamesThePatientOnlyIfAsked)
{
  this->OpenScan();
  const QByteArray anonymous = this->Sent(false);
  EXPECT_TRUE(anonymous.contains("DICM"));
  EXPECT_TRUE(anonymous.contains("No attribute of the scan is copied"));
  EXPECT_FALSE(anonymous.contains("Doe^Jane"));
  const QByteArray named = this->Sent(true);
  EXPECT_TRUE(named.contains("Doe^Jane"));
  EXPECT_TRUE(named.contains("ISO_IR 192"));
  const auto hasElement = [&named](const QByteArray& tag, const QByteArray& text)
  { return named.contains(QByteArray::fromHex(tag) + text); };
  EXPECT_TRUE(hasElement("20000d00", QByteArray("UI\4\0001.2\0", 8))) << "the study of the scan";
  EXPECT_TRUE(hasElement("08006000", QByteArray("CS\2\0OT", 6))) << "not the scan's modality, CT";
  EXPECT_FALSE(named.contains("No attribute of the scan is copied"));
}

TEST_F(Sending, AddsTheMeasurementsOfThePatientAsAReport)
{
  constexpr const char* ReportStorage = "1.2.840.10008.5.1.4.1.1.88.34"; // Comprehensive 3D SR
  this->OpenScan();
  EXPECT_FALSE(this->Sent(true).contains(ReportStorage)) << "nothing is measured";
  this->MeasureDistance();
  EXPECT_FALSE(this->Sent(false).contains(ReportStorage)) << "it would name the patient";
  const QByteArray report = this->Sent(true);
  EXPECT_TRUE(report.contains(ReportStorage));
  EXPECT_TRUE(report.contains("Doe^Jane"));
  EXPECT_TRUE(report.contains("SCOORD3D"));
}

TEST_F(Sending, NamesThePatientOfTheScanThatIsEdited)
{
  this->OpenScan();
  this->AddScanOfOther();
  this->MeasureDistance();
  const QByteArray ofSecond = this->Sent(true);
  EXPECT_EQ(ofSecond.count(QByteArray("UI\6\0001.2.77", 10)), 2) << "the image and the report";
  EXPECT_FALSE(ofSecond.contains("Doe^Jane"));
  this->window.Model()->SetEditedVolume(0);
  const QByteArray ofFirst = this->Sent(true);
  EXPECT_TRUE(ofFirst.contains("Doe^Jane"));
  EXPECT_FALSE(ofFirst.contains("1.2.77"));
}
