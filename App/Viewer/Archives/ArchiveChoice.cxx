#include "Viewer/Archives/ArchiveChoice.h"

#include "Archive/Archive.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFile>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>

namespace varimarch
{

namespace
{

const QString LastArchiveKey = QStringLiteral("lastArchive");

}

ArchiveChoice::ArchiveChoice(QWidget* parent)
  : QWidget(parent)
  , archives(KeptArchives())
  , box(new QComboBox)
  , edit(new QPushButton(tr("Edit…")))
  , remove(new QPushButton(tr("Remove")))
{
  auto* const add = new QPushButton(tr("Add…"));
  add->setObjectName("addArchive");
  this->box->setObjectName("archives");
  this->box->setAccessibleName(tr("Archive"));
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Archive")));
  row->addWidget(this->box, 1);
  for (QPushButton* const button : { add, this->edit, this->remove })
  {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  connect(add, &QPushButton::clicked, this, &ArchiveChoice::Add);
  connect(this->edit, &QPushButton::clicked, this, &ArchiveChoice::Edit);
  connect(this->remove, &QPushButton::clicked, this, &ArchiveChoice::Remove);
  connect(this->box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    &ArchiveChoice::KeepChoice);
  this->List(QSettings().value(LastArchiveKey).toInt());
}

void ArchiveChoice::List(int chosen)
{
  {
    const QSignalBlocker quiet(this->box);
    this->box->clear();
    for (const NamedArchive& archive : this->archives)
    {
      this->box->addItem(archive.name);
    }
    this->box->setCurrentIndex(std::clamp(chosen, -1, this->archives.size() - 1));
  }
  this->edit->setEnabled(!this->archives.isEmpty());
  this->remove->setEnabled(!this->archives.isEmpty());
  this->KeepChoice();
}

void ArchiveChoice::KeepChoice()
{
  QSettings().setValue(LastArchiveKey, this->box->currentIndex());
  emit this->Changed();
}

std::optional<NamedArchive> ArchiveChoice::Chosen() const
{
  const int row = this->box->currentIndex();
  return row < 0 ? std::nullopt : std::optional(this->archives[row]);
}

void ArchiveChoice::Add()
{
  this->EditRow(this->archives.size(), {});
}

void ArchiveChoice::Edit()
{
  const int row = this->box->currentIndex();
  this->EditRow(row, this->archives[row]);
}

void ArchiveChoice::EditRow(int row, const NamedArchive& archive)
{
  auto* const form = new ArchiveForm(archive, this);
  form->setAttribute(Qt::WA_DeleteOnClose);
  connect(form, &QDialog::accepted, this,
    [this, row, form]
    {
      if (row == this->archives.size())
      {
        this->archives.append(form->Edited());
      }
      else
      {
        this->archives[row] = form->Edited();
      }
      KeepArchives(this->archives);
      this->List(row);
    });
  form->open();
}

void ArchiveChoice::Remove()
{
  const int row = this->box->currentIndex();
  this->archives.remove(row);
  KeepArchives(this->archives);
  this->List(std::max(0, row - 1));
}

namespace
{

constexpr int UsualPort = 104; // registered for DICOM
constexpr int MostPort = 65535;

// A field that screen readers and tests know by a name.
template <class Field>
Field* Named(Field* field, const char* name)
{
  field->setObjectName(name);
  return field;
}

}

ArchiveForm::ArchiveForm(const NamedArchive& archive, QWidget* parent)
  : QDialog(parent)
  , name(Named(new QLineEdit, "name"))
  , kind(Named(new QComboBox, "kind"))
  , host(Named(new QLineEdit, "host"))
  , port(Named(new QSpinBox, "port"))
  , title(Named(new QLineEdit, "title"))
  , ownTitle(Named(new QLineEdit, "ownTitle"))
  , returnPort(Named(new QSpinBox, "returnPort"))
  , encrypted(Named(new QCheckBox(tr("Encrypted (TLS)")), "encrypted"))
  , url(Named(new QLineEdit, "url"))
  , user(Named(new QLineEdit, "user"))
  , certificate(Named(new QLineEdit, "certificate"))
  , ownCertificate(Named(new QLineEdit, "ownCertificate"))
  , rows(new QFormLayout)
  , status(Named(new QLabel, "status"))
{
  this->setWindowTitle(tr("Set up an archive"));
  this->resize(520, 0);
  this->status->setTextFormat(Qt::PlainText);
  this->status->setWordWrap(true);
  this->MakeRows(this->rows);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QPushButton* const test = buttons->addButton(tr("Test"), QDialogButtonBox::ActionRole);
  test->setObjectName("test");
  test->setToolTip(tr("Asks the archive to answer"));
  auto* const column = new QVBoxLayout(this);
  column->addLayout(this->rows);
  column->addWidget(this->status);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ArchiveForm::Finish);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(test, &QPushButton::clicked, this, &ArchiveForm::TryOut);
  connect(
    this->kind, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ArchiveForm::ShowRows);
  connect(&this->task, &BackgroundTask::Failed, this->status, &QLabel::setText);
  this->Show(archive);
}

void ArchiveForm::MakeRows(QFormLayout* form)
{
  this->kind->addItems({ tr("DICOM (C-FIND, C-GET, C-STORE)"), tr("DICOMweb") });
  this->port->setRange(1, MostPort);
  this->returnPort->setRange(0, MostPort);
  this->returnPort->setSpecialValueText(tr("none, by C-GET"));
  this->returnPort->setToolTip(
    tr("For archives that send only by C-MOVE, to a port that they know by our title"));
  this->url->setPlaceholderText("https://pacs.example.org/dicom-web");
  this->user->setPlaceholderText(tr("none"));
  this->user->setToolTip(tr("The password is asked for when it is needed, and is not kept"));
  this->certificate->setPlaceholderText(tr("file in PEM; none for a known authority"));
  this->ownCertificate->setPlaceholderText(tr("none"));
  this->ownCertificate->setToolTip(
    tr("A file in PEM with our certificate and its private key without a password, if the archive "
       "asks for it; encrypted C-MOVE needs it"));
  form->addRow(tr("Name"), this->name);
  form->addRow(tr("Protocol"), this->kind);
  form->addRow(tr("URL"), this->url);
  form->addRow(tr("Host"), this->host);
  form->addRow(tr("Port"), this->port);
  form->addRow(tr("Title of the archive (AE)"), this->title);
  form->addRow(tr("Our title (AE)"), this->ownTitle);
  form->addRow(tr("Port for C-MOVE"), this->returnPort);
  form->addRow(QString(), this->encrypted);
  form->addRow(tr("User"), this->user);
  form->addRow(tr("Certificate"), this->certificate);
  form->addRow(tr("Our certificate"), this->ownCertificate);
}

void ArchiveForm::Show(const NamedArchive& archive)
{
  const QUrl address(QString::fromStdString(archive.address.url));
  const bool isWeb = address.scheme().startsWith("http");
  this->name->setText(archive.name);
  this->kind->setCurrentIndex(isWeb ? 1 : 0);
  this->url->setText(isWeb ? address.toString() : QString());
  this->host->setText(isWeb ? QString() : address.host());
  this->port->setValue(isWeb ? UsualPort : address.port(UsualPort));
  this->title->setText(address.userName());
  this->ownTitle->setText(QString::fromStdString(archive.address.ownTitle));
  this->returnPort->setValue(archive.address.returnPort);
  this->encrypted->setChecked(address.scheme() == "dicoms");
  this->user->setText(QString::fromStdString(archive.address.user));
  this->certificate->setText(QString::fromStdString(archive.address.certificate));
  this->ownCertificate->setText(QString::fromStdString(archive.address.ownCertificate));
  this->ShowRows();
}

bool ArchiveForm::IsWeb() const
{
  return this->kind->currentIndex() == 1;
}

void ArchiveForm::ShowRows()
{
  const bool isWeb = this->IsWeb();
  const auto show = [this](QWidget* field, bool isShown)
  {
    field->setVisible(isShown);
    if (QWidget* const label = this->rows->labelForField(field))
    {
      label->setVisible(isShown);
    }
  };
  for (QWidget* const field :
    { static_cast<QWidget*>(this->url), static_cast<QWidget*>(this->user) })
  {
    show(field, isWeb);
  }
  for (QWidget* const field : { static_cast<QWidget*>(this->host),
         static_cast<QWidget*>(this->port), static_cast<QWidget*>(this->title),
         static_cast<QWidget*>(this->ownTitle), static_cast<QWidget*>(this->returnPort),
         static_cast<QWidget*>(this->encrypted), static_cast<QWidget*>(this->ownCertificate) })
  {
    show(field, !isWeb);
  }
}

NamedArchive ArchiveForm::Edited() const
{
  NamedArchive archive;
  archive.name = this->name->text().trimmed();
  archive.address.certificate = this->certificate->text().trimmed().toStdString();
  if (this->IsWeb())
  {
    archive.address.url = this->url->text().trimmed().toStdString();
    archive.address.user = this->user->text().trimmed().toStdString();
    return archive;
  }
  QUrl address;
  address.setScheme(this->encrypted->isChecked() ? "dicoms" : "dicom");
  address.setUserName(this->title->text().trimmed());
  address.setHost(this->host->text().trimmed());
  address.setPort(this->port->value());
  archive.address.url = address.toString(QUrl::FullyEncoded).toStdString();
  archive.address.ownTitle = this->ownTitle->text().trimmed().toStdString();
  archive.address.returnPort = this->returnPort->value();
  archive.address.ownCertificate = this->ownCertificate->text().trimmed().toStdString();
  return archive;
}

void ArchiveForm::TryOut()
{
  const NamedArchive archive = this->Edited();
  const auto password = PasswordOf(archive, this);
  if (!password)
  {
    return;
  }
  this->status->setText(tr("Waiting for the archive…"));
  this->task.Start([address = archive.address, password = *password](const TaskProgress& goesOn)
    { ArchiveAt(address, password)->Check(goesOn); },
    [this] { this->status->setText(tr("The archive answers.")); });
}

void ArchiveForm::Finish()
{
  try
  {
    const NamedArchive archive = this->Edited();
    CheckAddress(archive.address);
    if (archive.name.isEmpty())
    {
      this->name->setText(QUrl(QString::fromStdString(archive.address.url)).host());
    }
    this->accept();
  }
  catch (const std::exception& problem)
  {
    this->status->setText(QString::fromStdString(problem.what()));
  }
}

namespace
{

const QString ArchivesKey = QStringLiteral("archives");

}

QVector<NamedArchive> KeptArchives()
{
  QVector<NamedArchive> archives;
  QSettings settings;
  const int count = settings.beginReadArray(ArchivesKey);
  for (int i = 0; i < count; ++i)
  {
    settings.setArrayIndex(i);
    const auto text = [&](const char* key) { return settings.value(key).toString().toStdString(); };
    NamedArchive archive;
    archive.name = settings.value("name").toString();
    archive.address.url = text("url");
    archive.address.ownTitle = text("ownTitle");
    archive.address.certificate = text("certificate");
    archive.address.ownCertificate = text("ownCertificate");
    archive.address.returnPort = settings.value("returnPort").toInt();
    archive.address.user = text("user");
    archives.append(archive);
  }
  return archives;
}

void KeepArchives(const QVector<NamedArchive>& archives)
{
  QSettings settings;
  settings.remove(ArchivesKey);
  settings.beginWriteArray(ArchivesKey, archives.size());
  for (int i = 0; i < archives.size(); ++i)
  {
    settings.setArrayIndex(i);
    const ArchiveAddress& address = archives[i].address;
    settings.setValue("name", archives[i].name);
    settings.setValue("url", QString::fromStdString(address.url));
    settings.setValue("ownTitle", QString::fromStdString(address.ownTitle));
    settings.setValue("certificate", QString::fromStdString(address.certificate));
    settings.setValue("ownCertificate", QString::fromStdString(address.ownCertificate));
    settings.setValue("returnPort", address.returnPort);
    settings.setValue("user", QString::fromStdString(address.user));
  }
  settings.endArray();
  settings.sync();
  QFile::setPermissions(settings.fileName(), QFile::ReadOwner | QFile::WriteOwner);
}

std::optional<std::string> PasswordOf(const NamedArchive& archive, QWidget* parent)
{
  if (archive.address.user.empty())
  {
    return std::string();
  }
  bool isGiven = false;
  const QString password =
    QInputDialog::getText(parent, QCoreApplication::translate("ArchiveList", "Password"),
      QCoreApplication::translate("ArchiveList", "Password of %1 for %2. It is not kept.")
        .arg(QString::fromStdString(archive.address.user), archive.name),
      QLineEdit::Password, {}, &isGiven);
  return isGiven ? std::optional(password.toStdString()) : std::nullopt;
}

}
