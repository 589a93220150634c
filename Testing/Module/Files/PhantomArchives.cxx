// The archives of PhantomFiles.h.
#include "PhantomFiles.h"

#include <archive.h>
#include <archive_entry.h>

#include <memory>
#include <stdexcept>

namespace
{

constexpr std::size_t mostBytes = 1 << 22;

void Check(archive* writer, long result)
{
  if (result < ARCHIVE_OK)
  {
    throw std::runtime_error(archive_error_string(writer));
  }
}

void AddEntry(archive* writer, const ArchiveEntry& item)
{
  const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(
    archive_entry_new(), &archive_entry_free);
  archive_entry_set_pathname(entry.get(), item.path.c_str());
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_filetype(entry.get(), item.linkTarget.empty() ? AE_IFREG : AE_IFLNK);
  archive_entry_set_size(entry.get(), la_int64_t(item.bytes.size()));
  if (!item.linkTarget.empty())
  {
    archive_entry_set_symlink(entry.get(), item.linkTarget.c_str());
  }
  Check(writer, archive_write_header(writer, entry.get()));
  Check(writer, archive_write_data(writer, item.bytes.data(), item.bytes.size()));
}

}

std::string Archived(
  const std::vector<ArchiveEntry>& entries, const std::string& format, const std::string& filter)
{
  const std::unique_ptr<archive, decltype(&archive_write_free)> writer(
    archive_write_new(), &archive_write_free);
  Check(writer.get(), archive_write_set_format_by_name(writer.get(), format.c_str()));
  if (!filter.empty())
  {
    Check(writer.get(), archive_write_add_filter_by_name(writer.get(), filter.c_str()));
  }
  std::string bytes(mostBytes, '\0');
  std::size_t used = 0;
  Check(writer.get(), archive_write_open_memory(writer.get(), bytes.data(), bytes.size(), &used));
  for (const ArchiveEntry& entry : entries)
  {
    AddEntry(writer.get(), entry);
  }
  Check(writer.get(), archive_write_close(writer.get()));
  bytes.resize(used);
  return bytes;
}

std::string Compressed(const std::string& bytes, const std::string& filter)
{
  return Archived({ { "file", bytes } }, "raw", filter);
}
