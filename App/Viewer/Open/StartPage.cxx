#include "Viewer/Open/StartPage.h"

#include <QCommandLinkButton>
#include <QFile>
#include <QLabel>
#include <QVBoxLayout>

namespace varimarch
{

namespace
{

// The head CT of Debian's package invesalius-examples.
const QString SampleHead =
  QStringLiteral("/usr/share/doc/invesalius-examples/examples/Cranium.inv3");

constexpr int ColumnPixels = 440;
constexpr int MostRecentScans = 4;

void AddHeading(QVBoxLayout* column, const QString& text)
{
  auto* const heading = new QLabel("<b>" + text + "</b>");
  heading->setContentsMargins(0, 12, 0, 2);
  column->addWidget(heading);
}

QCommandLinkButton* AddButton(QVBoxLayout* column, const QString& text, const QString& explanation)
{
  auto* const button = new QCommandLinkButton(text, explanation);
  column->addWidget(button);
  return button;
}

}

VolumeSource SampleTorso()
{
  return ProceduralSource{ ProceduralKind::Torso, { 192, 160, 128 } };
}

StartPage::StartPage(const RecentScans& recentScans, QWidget* parent)
  : QWidget(parent)
{
  auto* const page = new QVBoxLayout(this);
  auto* const middle = new QWidget;
  middle->setFixedWidth(ColumnPixels);
  auto* const column = new QVBoxLayout(middle);
  column->setSpacing(2);
  AddHeading(column, tr("Open a scan, or drop one on this window"));
  connect(
    AddButton(column, tr("Open a file…"), tr("NIfTI, NRRD, MetaImage, a ZIP of a CD, a session …")),
    &QAbstractButton::clicked, this, &StartPage::FileWanted);
  connect(AddButton(column, tr("Open a folder…"), tr("A CD, or the slices of a DICOM series")),
    &QAbstractButton::clicked, this, &StartPage::FolderWanted);
  this->AddRecentScans(column, recentScans);
  this->AddSamples(column);
  page->addStretch();
  page->addWidget(middle, 0, Qt::AlignHCenter);
  page->addStretch();
}

void StartPage::AddRecentScans(QVBoxLayout* column, const RecentScans& recentScans)
{
  const QVector<RecentScan> scans = recentScans.List().mid(0, MostRecentScans);
  if (scans.isEmpty())
  {
    return;
  }
  AddHeading(column, tr("Recent scans"));
  for (const RecentScan& scan : scans)
  {
    connect(AddButton(column, scan.Title(), scan.Opened()), &QAbstractButton::clicked, this,
      [this, scan] { emit this->ScanWanted(scan.path, scan.series); });
  }
}

void StartPage::AddSamples(QVBoxLayout* column)
{
  AddHeading(column, tr("Samples"));
  if (QFile::exists(SampleHead))
  {
    connect(AddButton(column, tr("Head CT"), tr("From the package invesalius-examples")),
      &QAbstractButton::clicked, this, [this] { emit this->ScanWanted(SampleHead, {}); });
  }
  QCommandLinkButton* const torso =
    AddButton(column, tr("Phantom of a torso"), tr("Computed, with bones, lungs and vessels"));
  torso->setObjectName("sampleTorso");
  connect(
    torso, &QAbstractButton::clicked, this, [this] { emit this->SampleWanted(SampleTorso()); });
  QCommandLinkButton* const tour =
    AddButton(column, tr("Two-minute tour"), tr("What is where, on the phantom"));
  tour->setObjectName("tourOfStart");
  connect(tour, &QAbstractButton::clicked, this, &StartPage::TourWanted);
}

}
