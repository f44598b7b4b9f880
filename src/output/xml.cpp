#include "output/xml.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <expat.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <type_traits>

namespace blockfsi::output
{

namespace
{

/// Deeper elements than any mesh has.
constexpr std::size_t deepest = 32;

/// The elements that are open while a document is read. The content of an element moves to its parent when it
/// ends.
struct Reading
{
  XML_Parser parser = nullptr;
  std::vector<XmlElement> open;
  XmlElement root;
  std::string fault;  ///< what stopped the parser, if it was we
};

void stop(Reading& reading, std::string fault)
{
  reading.fault = std::move(fault);
  XML_StopParser(reading.parser, XML_FALSE);
}

void XMLCALL begin(void* data, const XML_Char* name, const XML_Char** attributes)
{
  Reading& reading = *static_cast<Reading*>(data);
  if (reading.open.size() == deepest)
    return stop(reading, fmt::format("elements are nested more than {} deep", deepest));
  XmlElement& element = reading.open.emplace_back();
  element.name = name;
  element.line = static_cast<int>(
      std::min<XML_Size>(XML_GetCurrentLineNumber(reading.parser), std::numeric_limits<int>::max()));
  for (std::size_t i = 0; attributes[i] != nullptr; i += 2)
    element.attributes[attributes[i]] = attributes[i + 1];
}

void close_last(Reading& reading)
{
  XmlElement element = std::move(reading.open.back());
  reading.open.pop_back();
  if (reading.open.empty())
    reading.root = std::move(element);
  else
    reading.open.back().children.push_back(std::move(element));
}

void XMLCALL end(void* data, const XML_Char*)
{
  close_last(*static_cast<Reading*>(data));
}

void XMLCALL text(void* data, const XML_Char* characters, int count)
{
  Reading& reading = *static_cast<Reading*>(data);
  if (!reading.open.empty())
    reading.open.back().text.append(characters, count);
}

void XMLCALL document_type(void* data, const XML_Char*, const XML_Char*, const XML_Char*, int)
{
  stop(*static_cast<Reading*>(data), "a document type declaration is not allowed");
}

}  // namespace

const XmlElement* XmlElement::child(std::string_view wanted) const
{
  const auto found = std::find_if(children.begin(), children.end(),
                                  [wanted](const XmlElement& element) { return element.name == wanted; });
  return found == children.end() ? nullptr : &*found;
}

std::string_view XmlElement::attribute(std::string_view wanted, std::string_view otherwise) const
{
  const auto found = attributes.find(wanted);
  return found == attributes.end() ? otherwise : std::string_view(found->second);
}

XmlElement parse_xml(std::string_view content, const std::string& file, bool cut_off)
{
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), &XML_ParserFree);
  Reading reading;
  reading.parser = parser.get();
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), begin, end);
  XML_SetCharacterDataHandler(parser.get(), text);
  XML_SetStartDoctypeDeclHandler(parser.get(), document_type);
  constexpr std::size_t portion = std::size_t{1} << 24;
  XML_Status status = XML_STATUS_OK;
  do
  {
    const std::string_view part = content.substr(0, portion);
    content.remove_prefix(part.size());
    status = XML_Parse(parser.get(), part.data(), static_cast<int>(part.size()),
                       content.empty() && !cut_off ? XML_TRUE : XML_FALSE);
  } while (status == XML_STATUS_OK && !content.empty());
  if (status != XML_STATUS_OK)
  {
    const std::string fault =
        reading.fault.empty() ? XML_ErrorString(XML_GetErrorCode(parser.get())) : reading.fault;
    throw Error({file, static_cast<int>(XML_GetCurrentLineNumber(parser.get())),
                 static_cast<int>(XML_GetCurrentColumnNumber(parser.get())) + 1},
                fmt::format("this is no XML file of a mesh: {}", fault));
  }
  while (!reading.open.empty())
    close_last(reading);
  return std::move(reading.root);
}

}  // namespace blockfsi::output
