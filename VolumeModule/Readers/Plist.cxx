#include "Readers/Plist.h"

#include "Readers/FileError.h"
#include "Readers/Nesting.h"

#include <plist/plist.h>

#include <cstdint>
#include <sstream>

namespace varimarch
{
namespace
{

bool IsDictionary(plist_t node)
{
  return node && plist_get_node_type(node) == PLIST_DICT;
}

std::string TextOf(plist_t node)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  std::uint64_t integer = 0;
  double real = 0.0;
  switch (node ? plist_get_node_type(node) : PLIST_NONE)
  {
    case PLIST_STRING:
      text << plist_get_string_ptr(node, nullptr);
      break;
    case PLIST_UINT:
      // libplist keeps negative integers as their complements.
      plist_get_uint_val(node, &integer);
      text << std::int64_t(integer);
      break;
    case PLIST_REAL:
      plist_get_real_val(node, &real);
      text << real;
      break;
    default:
      break;
  }
  return text.str();
}

}

Plist::Plist(const std::string& path, const std::string& bytes)
  : path(path)
{
  if (MayBeNestedTooDeep(bytes))
  {
    FailToRead(path,
      "a property list of at most " + std::to_string(MostNestedElements) + " elements", "more");
  }
  plist_t top = nullptr;
  plist_from_memory(bytes.data(), std::uint32_t(bytes.size()), &top);
  this->root = std::shared_ptr<void>(top, &plist_free);
  this->dictionary = top;
  if (!IsDictionary(top))
  {
    FailToRead(path, "a property list that is a dictionary", Quoted(bytes));
  }
}

Plist::Plist(const std::string& path, std::shared_ptr<void> root, Node dictionary)
  : path(path)
  , root(std::move(root))
  , dictionary(dictionary)
{
}

Plist::Node Plist::Value(const std::string& key) const
{
  return plist_dict_get_item(this->dictionary, key.c_str());
}

std::string Plist::Text(const std::string& key) const
{
  return TextOf(this->Value(key));
}

std::vector<std::string> Plist::Texts(const std::string& key) const
{
  std::vector<std::string> texts;
  const Node value = this->Value(key);
  const std::uint32_t count =
    value && plist_get_node_type(value) == PLIST_ARRAY ? plist_array_get_size(value) : 0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    texts.push_back(TextOf(plist_array_get_item(value, i)));
  }
  return texts;
}

Plist Plist::Dictionary(const std::string& key) const
{
  const Node value = this->Value(key);
  if (!IsDictionary(value))
  {
    FailToRead(this->path, "a property list with the dictionary " + Quoted(key), "none");
  }
  return Plist(this->path, this->root, value);
}

}
