#include "Viewer/Studies/StudyListWindow.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Dicom/FileSearch.h"
#include "Readers/Dicom/Metadata.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QUuid>
#include <QVariant>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

// Another layout of the tables has another number; a file of another number is made anew.
constexpr int LayoutVersion = 1;

// So many images are kept in one transaction, so that little is lost if the program is killed.
constexpr std::size_t ImagesPerTransaction = 500;

[[noreturn]] void FailOnIndex(const QString& file, const QString& found)
{
  throw std::runtime_error(QCoreApplication::translate("StudyIndex",
    "The study list \"%1\" cannot be used: %2. Remove the list and add its folders again.")
                             .arg(file, found)
                             .toStdString());
}

// The open database, for one thread.
class Connection
{
public:
  explicit Connection(const QString& file)
    : file(file)
    , name(QUuid::createUuid().toString())
    , database(QSqlDatabase::addDatabase("QSQLITE", this->name))
  {
    this->MakePrivateFile();
    this->database.setDatabaseName(file);
    if (!this->database.open())
    {
      FailOnIndex(file, this->database.lastError().text());
    }
    this->MakeTables();
  }

  ~Connection()
  {
    this->database.close();
    this->database = {};
    QSqlDatabase::removeDatabase(this->name);
  }

  Connection(const Connection&) = delete;
  void operator=(const Connection&) = delete;

  // Runs a statement with these values.
  QSqlQuery Run(const QString& statement, const QVariantList& values = {})
  {
    QSqlQuery query(this->database);
    query.setForwardOnly(true);
    bool isRun = query.prepare(statement);
    for (const QVariant& value : values)
    {
      query.addBindValue(value);
    }
    isRun = isRun && query.exec();
    if (!isRun)
    {
      FailOnIndex(this->file, query.lastError().text());
    }
    return query;
  }

  void Begin() { this->database.transaction(); }
  void Commit()
  {
    if (!this->database.commit())
    {
      FailOnIndex(this->file, this->database.lastError().text());
    }
  }

private:
  // SQLite keeps the permissions of a file that is there, and gives them to its journal.
  void MakePrivateFile() const
  {
    QDir().mkpath(QFileInfo(this->file).path());
    QFile made(this->file);
    const auto onlyOurs = QFile::ReadOwner | QFile::WriteOwner;
    const bool isPrivate = made.open(QIODevice::ReadWrite) && made.setPermissions(onlyOurs);
    if (!isPrivate)
    {
      FailOnIndex(this->file, made.errorString());
    }
  }

  void MakeTables()
  {
    this->Run("PRAGMA secure_delete = ON"); // removed bytes are overwritten
    QSqlQuery version = this->Run("PRAGMA user_version");
    if (version.next() && version.value(0).toInt() == LayoutVersion)
    {
      return;
    }
    version.finish();
    this->Run("DROP TABLE IF EXISTS folders");
    this->Run("DROP TABLE IF EXISTS images");
    this->Run("CREATE TABLE folders (path TEXT PRIMARY KEY)");
    // Files without images are in the table too, so that they are not read again.
    this->Run(
      "CREATE TABLE images (folder TEXT, path TEXT, bytes INTEGER, changed INTEGER, "
      "patient_name TEXT, patient_id TEXT, study_uid TEXT, study_date TEXT, "
      "study_description TEXT, series_uid TEXT, series_number INTEGER, "
      "series_description TEXT, modality TEXT, image_uid TEXT, PRIMARY KEY (folder, path))");
    this->Run("PRAGMA user_version = " + QString::number(LayoutVersion));
  }

  QString file;
  QString name;
  QSqlDatabase database;
};

// Size and time by which a changed file is known.
struct FileState
{
  qint64 bytes;
  qint64 changed; ///< [ms since 1970]

  bool operator==(const FileState& other) const
  {
    return this->bytes == other.bytes && this->changed == other.changed;
  }
};

FileState StateOf(const QString& path)
{
  const QFileInfo info(path);
  return { info.size(), info.lastModified().toMSecsSinceEpoch() };
}

// The files that are in the list, with their states.
QHash<QString, FileState> KnownFiles(Connection& connection, const QString& folder)
{
  QHash<QString, FileState> known;
  QSqlQuery query =
    connection.Run("SELECT path, bytes, changed FROM images WHERE folder = ?", { folder });
  while (query.next())
  {
    known.insert(
      query.value(0).toString(), { query.value(1).toLongLong(), query.value(2).toLongLong() });
  }
  return known;
}

// Adds a file to the list, unless its folder was forgotten meanwhile.
void Keep(
  Connection& connection, const QString& folder, const QString& path, const DicomRecord& record)
{
  const FileState state = StateOf(path);
  QVariantList values = { folder, path, state.bytes, state.changed };
  for (const std::string* const text : { &record.patientName, &record.patientId, &record.studyUid,
         &record.studyDate, &record.studyDescription, &record.seriesUid })
  {
    values.append(QString::fromStdString(*text));
  }
  values.append(record.seriesNumber);
  for (const std::string* const text :
    { &record.seriesDescription, &record.modality, &record.imageUid })
  {
    values.append(QString::fromStdString(*text));
  }
  values.append(folder);
  connection.Run("INSERT OR REPLACE INTO images SELECT ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ? "
                 "WHERE EXISTS (SELECT path FROM folders WHERE path = ?)",
    values);
}

// Images that were read but are not in the list yet. A transaction locks the list for other windows
// and programs, so there is none while a file is read.
class ReadImages
{
public:
  ReadImages(Connection& connection, const QString& folder)
    : connection(connection)
    , folder(folder)
  {
  }

  void Add(const std::string& path, const DicomRecord& record)
  {
    this->images.emplace_back(QString::fromStdString(path), record);
    if (this->images.size() == ImagesPerTransaction)
    {
      this->KeepAll();
    }
  }

  void KeepAll()
  {
    this->connection.Begin();
    for (const auto& [path, record] : this->images)
    {
      Keep(this->connection, this->folder, path, record);
    }
    this->connection.Commit();
    this->images.clear();
  }

private:
  Connection& connection;
  QString folder;
  std::vector<std::pair<QString, DicomRecord>> images;
};

// Removes the files that are gone from the list, and returns those that are new or have changed.
std::vector<std::string> ForgetGone(
  Connection& connection, const QString& folder, const std::vector<std::string>& files)
{
  QHash<QString, FileState> known = KnownFiles(connection, folder);
  std::vector<std::string> changed;
  for (const std::string& path : files)
  {
    const QString name = QString::fromStdString(path);
    const auto place = known.find(name);
    if (place == known.end() || !(place.value() == StateOf(name)))
    {
      changed.push_back(path);
    }
    known.remove(name);
  }
  connection.Begin();
  for (auto gone = known.begin(); gone != known.end(); ++gone)
  {
    connection.Run("DELETE FROM images WHERE folder = ? AND path = ?", { folder, gone.key() });
  }
  connection.Commit();
  return changed;
}

// The folder that all paths between two lie in, in the order of letters; the path if they are one.
QString CommonPath(const QString& first, const QString& last)
{
  int end = 0;
  while (end < first.size() && end < last.size() && first[end] == last[end])
  {
    ++end;
  }
  return first == last ? first : first.left(first.lastIndexOf('/', end - 1));
}

}

bool StudyIndex::Exists() const
{
  return QFile::exists(this->file);
}

QStringList StudyIndex::Folders() const
{
  QStringList folders;
  if (this->Exists())
  {
    Connection connection(this->file);
    QSqlQuery query = connection.Run("SELECT path FROM folders ORDER BY path");
    while (query.next())
    {
      folders.append(query.value(0).toString());
    }
  }
  return folders;
}

QVector<IndexedSeries> StudyIndex::Series() const
{
  QVector<IndexedSeries> all;
  if (!this->Exists())
  {
    return all;
  }
  Connection connection(this->file);
  QSqlQuery query = connection.Run(
    "SELECT patient_name, patient_id, study_uid, MAX(study_date), MAX(study_description), "
    "series_uid, MAX(series_number), MAX(series_description), modality, "
    "COUNT(DISTINCT image_uid), MIN(path), MAX(path) FROM images WHERE series_uid <> '' "
    "GROUP BY folder, patient_name, patient_id, study_uid, series_uid, modality "
    "ORDER BY patient_name COLLATE NOCASE, patient_id, 4 DESC, study_uid, 7, series_uid");
  while (query.next())
  {
    const auto text = [&](int column) { return query.value(column).toString(); };
    all.append({ text(0), text(1), text(2), text(3), text(4), text(5), query.value(6).toInt(),
      text(7), text(8), query.value(9).toInt(), CommonPath(text(10), text(11)) });
  }
  return all;
}

void StudyIndex::Update(const QString& folder, const TaskProgress& goesOn) const
{
  // A disk that is away must not empty the list.
  if (!QFileInfo(folder).isDir())
  {
    throw std::runtime_error(QCoreApplication::translate("StudyIndex",
      "The folder \"%1\" cannot be read: it is not there, or its disk is away. What the list "
      "knows of it stays.")
                               .arg(folder)
                               .toStdString());
  }
  const DecoderSession session;
  ReadProgress progress(goesOn);
  ReadProgress searching = progress.Part(0.0, 0.1);
  ReadProgress reading = progress.Part(0.1, 1.0);
  std::vector<std::string> warnings;
  const auto files = FindDicomFiles(folder.toStdString(), warnings, searching);
  reading.Report(0.0); // a cancelled thread does not bring a removed folder back
  Connection connection(this->file);
  connection.Run("INSERT OR IGNORE INTO folders VALUES (?)", { folder });
  const std::vector<std::string> changed = ForgetGone(connection, folder, files);
  ReadImages images(connection, folder);
  const auto take = [&](std::size_t i, const DicomRecord& record)
  { images.Add(changed[i], record); };
  try
  {
    ForEachRecord(changed, take, reading);
  }
  catch (const ReadCancelled&)
  {
    images.KeepAll();
    throw;
  }
  images.KeepAll();
}

void StudyIndex::Forget(const QString& folder) const
{
  Connection connection(this->file);
  connection.Run("DELETE FROM folders WHERE path = ?", { folder });
  connection.Run("DELETE FROM images WHERE folder = ?", { folder });
}

// SQLite overwrites the rows before the file is removed. A damaged file is only removed.
void StudyIndex::RemoveAll() const
{
  try
  {
    for (const QString& folder : this->Folders())
    {
      this->Forget(folder);
    }
  }
  catch (const std::runtime_error&)
  {
  }
  QFile::remove(this->file + "-journal");
  QFile database(this->file);
  if (database.exists() && !database.remove())
  {
    FailOnIndex(this->file, database.errorString());
  }
}

}
