// The windows of archives, operated as a user does, with a server that answers by a table.

#include "Answers.h"
#include "Archive/Archive.h"
#include "FakeDimseArchive.h"
#include "FakeWebArchive.h"
#include "Module/Files/PhantomFiles.h"
#include "Readers/Packed/PrivateFolder.h"
#include "Scene/Volumes/VolumeLoading.h"
#include "Viewer/Archives/ArchiveChoice.h"
#include "Viewer/Archives/ArchiveWindow.h"
#include "Waiting.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <filesystem>

using namespace varimarch;

namespace
{

const QByteArray Json = "application/dicom+json";
const QByteArray Multipart = "multipart/related; type=\"application/dicom\"; boundary=limit";

QByteArray StudyJson(const QByteArray& uid, const QByteArray& name)
{
  return R"({"0020000D":{"vr":"UI","Value":[")" + uid +
    R"("]},"00100010":{"vr":"PN","Value":[{"Alphabetic":")" + name +
    R"("}]},"00080020":{"vr":"DA","Value":["20261126"]},)"
    R"("00080061":{"vr":"CS","Value":["CT","SEG"]}})";
}

// A message with the slices of a phantom.
QByteArray Images()
{
  QByteArray body;
  for (int slice = 0; slice < 3; ++slice)
  {
    DicomOptions options;
    options.instance = slice;
    body += "--limit\r\nContent-Type: application/dicom\r\n\r\n" +
      QByteArray::fromStdString(DicomBytes(phantom::Stored(0), slice, options)) + "\r\n";
  }
  return body + "--limit--";
}

class ArchiveOnScreen : public testing::Test
{
protected:
  ArchiveOnScreen()
  {
    QSettings().clear();
    KeepAsHospital(this->server.Url());
    this->window = std::make_unique<ArchiveWindow>(nullptr);
    this->window->setAttribute(Qt::WA_DeleteOnClose, false);
    this->window->show();
    QObject::connect(this->window.get(), &ArchiveWindow::Fetched, this->window.get(),
      [this](const QString& folder, const std::shared_ptr<const PrivateFolder>& temporary)
      {
        this->folder = folder;
        this->temporary = temporary;
      });
  }

  QString Status() const { return this->window->findChild<QLabel*>("status")->text(); }
  QTreeWidget* Tree() const { return this->window->findChild<QTreeWidget*>(); }
  void Press(const char* button) { this->window->findChild<QPushButton*>(button)->click(); }
  bool Says(const QString& text)
  {
    return QTest::qWaitFor([&] { return this->Status().contains(text); }, MostMilliseconds);
  }

  void SearchTwoStudies()
  {
    this->server.Answer("/studies", Json,
      '[' + StudyJson("1.2.2", "MAJOR^TOM") + ',' + StudyJson("1.2.1", "DOE^JANE") + ']');
    this->Press("search");
    ASSERT_TRUE(this->Says("Studies: 2")) << this->Status().toStdString();
  }

  void ListStudyOfDate(const QByteArray& date)
  {
    this->server.Answer(
      "/studies", Json, '[' + StudyJson("1.2.1", "DOE^JANE").replace("20261126", date) + ']');
    this->Press("search");
    ASSERT_TRUE(this->Says("Studies: 1")) << this->Status().toStdString();
    this->Tree()->setCurrentItem(this->Tree()->topLevelItem(0));
  }

  void Keep()
  {
    QDir(this->disk.path()).mkpath("a/scans");
    const Answers answers(QMessageBox::Yes, this->disk.filePath("a/scans"));
    this->Press("keep");
  }

  QStringList KeptFolders() const
  {
    return QDir(this->disk.filePath("a/scans")).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
  }

  QTemporaryDir disk;
  FakeWebArchive server;
  std::unique_ptr<ArchiveWindow> window;
  QString folder;
  std::shared_ptr<const PrivateFolder> temporary;
};

}

TEST_F(ArchiveOnScreen, FindsStudiesAndTheirSeries)
{
  this->window->findChild<QLineEdit*>("patientName")->setText("M");
  this->window->findChild<QLineEdit*>("modality")->setText("CT");
  this->SearchTwoStudies();
  const QString asked = this->server.requests.last();
  EXPECT_TRUE(asked.contains("PatientName=M*")) << asked.toStdString();
  EXPECT_TRUE(asked.contains("ModalitiesInStudy=CT")) << asked.toStdString();
  QTreeWidgetItem* const first = this->Tree()->topLevelItem(0);
  EXPECT_EQ(first->text(0), "DOE, JANE") << "sorted";
  EXPECT_EQ(first->text(3), "CT, SEG");
  this->server.Answer("/studies/1.2.1/series", Json,
    R"([{"0020000E":{"Value":["1.2.1.5"]},"00200011":{"Value":[5]},"0008103E":{"Value":["Thin"]}}])");
  first->setExpanded(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return first->childCount() == 1; }, MostMilliseconds));
  EXPECT_EQ(first->child(0)->text(0), "Series 5");
  EXPECT_EQ(first->child(0)->text(5), "Thin");
}

TEST_F(ArchiveOnScreen, OpensAScanThatVanishes)
{
  this->SearchTwoStudies();
  this->server.Answer("/studies/1.2.1", Multipart, Images());
  this->Tree()->setCurrentItem(this->Tree()->topLevelItem(0));
  this->Press("open");
  ASSERT_TRUE(this->Says("Fetched")) << this->Status().toStdString();
  ASSERT_TRUE(this->temporary);
  const LoadedVolume volume = LoadVolume(FileSource{ this->folder.toStdString(), std::nullopt });
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(volume.image->GetScalarComponentAsDouble(1, 2, k, 0), phantom::ValueAt({ 1, 2, k }));
  }
  this->temporary.reset();
  EXPECT_FALSE(QFile::exists(this->folder));
}

TEST_F(ArchiveOnScreen, KeepsAScanInAFolderThatTheArchiveDoesNotName)
{
  this->ListStudyOfDate("/../../evil");
  this->server.Answer("/studies/1.2.1", Multipart, Images());
  this->Keep();
  ASSERT_TRUE(this->Says("Fetched")) << this->Status().toStdString();
  EXPECT_FALSE(this->temporary);
  EXPECT_EQ(this->KeptFolders(), QStringList("scan-0-1"));
  EXPECT_EQ(QDir(this->folder).entryList(QDir::Files).size(), 3);
}

TEST_F(ArchiveOnScreen, KeepsNoPartOfAScan)
{
  this->ListStudyOfDate("20261126");
  this->server.Answer("/studies/1.2.1", Multipart, Images().chopped(100));
  this->Keep();
  ASSERT_TRUE(this->Says("ends early")) << this->Status().toStdString();
  EXPECT_EQ(this->KeptFolders(), QStringList());
}

TEST_F(ArchiveOnScreen, TellsASilentServerAndIsCancelled)
{
  NamedArchive archive = KeptArchives().first();
  archive.address.patience = 0.3;
  try
  {
    ArchiveAt(archive.address, {})->Check([](double) { return true; });
    FAIL() << "a silent server has answered";
  }
  catch (const std::runtime_error& problem)
  {
    EXPECT_NE(std::string(problem.what()).find("silent for 0.3 s"), std::string::npos)
      << problem.what();
  }
  this->Press("search");
  auto* const cancel = this->window->findChild<QPushButton*>("cancel");
  EXPECT_TRUE(cancel->isVisible());
  cancel->click();
  EXPECT_FALSE(cancel->isVisible());
  EXPECT_EQ(this->Status(), "It was cancelled");
}

TEST_F(ArchiveOnScreen, FetchesOnWhileAnotherStudyIsExpanded)
{
  this->SearchTwoStudies();
  this->Tree()->setCurrentItem(this->Tree()->topLevelItem(0));
  this->Press("open");
  const auto isFetching = [this]
  { return this->server.requests.last().endsWith("/studies/1.2.1"); };
  ASSERT_TRUE(QTest::qWaitFor(isFetching, MostMilliseconds)) << "of a server that does not answer";
  QTreeWidgetItem* const other = this->Tree()->topLevelItem(1);
  other->setExpanded(true);
  EXPECT_FALSE(other->isExpanded());
  EXPECT_EQ(this->Status(), "Fetching…");
  QTest::qWait(200);
  EXPECT_TRUE(isFetching()) << "no other request follows";
}

TEST_F(ArchiveOnScreen, ShowsTheFaultOfADamagedAnswer)
{
  this->server.Answer("/studies", Json, "[{");
  this->Press("search");
  EXPECT_TRUE(this->Says("its answer to a search is not a list in JSON"));
  EXPECT_EQ(this->Tree()->topLevelItemCount(), 0);
}

TEST_F(ArchiveOnScreen, AsksForNothingThatIsNoUid)
{
  this->server.Answer("/studies", Json, '[' + StudyJson("../<b>admin</b>", "DOE^JANE") + ']');
  this->Press("search");
  ASSERT_TRUE(this->Says("Studies: 1"));
  const int before = this->server.requests.size();
  this->Tree()->setCurrentItem(this->Tree()->topLevelItem(0));
  this->Press("open");
  EXPECT_TRUE(this->Says("\"../<b>admin</b>\": expected a UID")) << this->Status().toStdString();
  EXPECT_EQ(this->window->findChild<QLabel*>("status")->textFormat(), Qt::PlainText)
    << "a stranger's text is not markup";
  EXPECT_EQ(this->server.requests.size(), before);
}

TEST_F(ArchiveOnScreen, IsSetUpInAForm)
{
  this->Press("addArchive");
  auto* const form = this->window->findChild<ArchiveForm*>();
  ASSERT_TRUE(form);
  const auto type = [form](const char* field, const QString& text)
  { QTest::keyClicks(form->findChild<QLineEdit*>(field), text); };
  QPushButton* const ok = form->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  type("name", "clinic");
  type("host", "pacs.example");
  ok->click();
  EXPECT_TRUE(form->findChild<QLabel*>("status")->text().contains("title before '@'"))
    << "the title is missing";
  EXPECT_TRUE(form->isVisible());
  type("title", "CLINIC");
  form->findChild<QSpinBox*>("port")->setValue(11112);
  form->findChild<QSpinBox*>("returnPort")->setValue(4006);
  ok->click();
  ASSERT_EQ(KeptArchives().size(), 2);
  const NamedArchive kept = KeptArchives().last();
  EXPECT_EQ(kept.name, "clinic");
  EXPECT_EQ(kept.address.url, "dicom://CLINIC@pacs.example:11112");
  EXPECT_EQ(kept.address.ownTitle, "VARIMARCH");
  EXPECT_EQ(kept.address.returnPort, 4006);
  EXPECT_EQ(this->window->findChild<QComboBox*>("archives")->currentText(), "clinic");
  EXPECT_EQ(ArchiveChoice().Chosen()->name, "clinic") << "also in the next window";
  const auto others = QFile::ReadGroup | QFile::ReadOther;
  EXPECT_FALSE(QFile(QSettings().fileName()).permissions() & others);
}

TEST_F(ArchiveOnScreen, IsTriedOutInTheForm)
{
  this->server.Answer("/studies", Json, "[]");
  ArchiveForm form(KeptArchives().first(), nullptr);
  form.show();
  EXPECT_TRUE(form.findChild<QLineEdit*>("url")->isVisible());
  EXPECT_FALSE(form.findChild<QLineEdit*>("host")->isVisible());
  form.findChild<QPushButton*>("test")->click();
  auto* const status = form.findChild<QLabel*>("status");
  EXPECT_TRUE(
    QTest::qWaitFor([&] { return status->text() == "The archive answers."; }, MostMilliseconds));
}

// A name that is read in another set of characters is another name.
TEST_F(ArchiveOnScreen, SaysThatANameCannotBeRead)
{
  const FakeDimseArchive dimse(FakeDimseArchive::Attribute(0x0008, 0x0005, "ISO_IR 999") +
    FakeDimseArchive::Attribute(0x0010, 0x0010, "M\xfcller^Ute") +
    FakeDimseArchive::Attribute(0x0020, 0x000d, "1.2.3"));
  KeepAsHospital(dimse.Url());
  ArchiveWindow asking(nullptr);
  asking.setAttribute(Qt::WA_DeleteOnClose, false);
  asking.findChild<QPushButton*>("search")->click();
  const auto* const status = asking.findChild<QLabel*>("status");
  ASSERT_TRUE(QTest::qWaitFor(
    [&] { return status->text().startsWith("Studies: 1. Texts of 1 "); }, MostMilliseconds))
    << status->text().toStdString();
  EXPECT_EQ(asking.findChild<QTreeWidget*>()->topLevelItem(0)->text(0), "Unreadable name");
}

TEST_F(ArchiveOnScreen, KeepsItsCertificates)
{
  NamedArchive archive;
  archive.name = "clinic";
  archive.address.url = "dicoms://CLINIC@pacs.example:2762";
  archive.address.certificate = "clinic.pem";
  archive.address.ownCertificate = "us.pem";
  QVector<NamedArchive> archives;
  archives.append(archive);
  KeepArchives(archives);
  const ArchiveAddress kept = ArchiveForm(KeptArchives().first(), nullptr).Edited().address;
  EXPECT_EQ(kept.url, archive.address.url);
  EXPECT_EQ(kept.certificate, "clinic.pem");
  EXPECT_EQ(kept.ownCertificate, "us.pem");
}
