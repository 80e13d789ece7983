#include "ritz/readers/formats.hpp"

#include <algorithm>

#include "ritz/readers/inp_model.hpp"

namespace ritz::readers {

std::string needed(const Deck& deck, const Keyword& keyword, std::string_view parameter) {
  const auto value = keyword.value(parameter);
  if (!value) deck.fail(keyword.place, "*" + keyword.title + " needs " + std::string(parameter) + "=");
  return *value;
}

void leave_out(const Sources& sources, Place place, const std::vector<std::string>& words, const std::string& what,
               InpModel& model) {
  const bool said = model.words.contains(words.front());
  model.words.insert(words.begin(), words.end());
  if (said) return;
  const auto ignored = std::find_first_of(words.begin(), words.end(), model.ignored.begin(), model.ignored.end());
  leave_out(sources, place, ignored != words.end() ? *ignored : words.front(), what, model.ignored, model.mesh);
}

void read_keywords(Deck& deck, const std::string& end, Place begin, InpModel& model) {
  while (const auto keyword = deck.next_keyword()) {
    if (keyword->name == end) return;
    inp_handler(keyword->name)(deck, *keyword, model);
  }
  if (!end.empty())
    deck.fail(begin, "the file ends before the *" + end.substr(0, 3) + " " + end.substr(3) + " of this line");
}

InpModel read_inp_model(Sources& sources, unsigned file, const Ignored& ignored) {
  Deck deck(sources, file);
  InpModel model;
  model.ignored = ignored;
  read_keywords(deck, {}, {}, model);
  choose_supports(sources, model);
  note_instances(model);
  resolve_inp(sources, model);
  return model;
}

FileMesh read_inp(Sources& sources, unsigned file, const Ignored& ignored) {
  auto model = read_inp_model(sources, file, ignored);
  note_idle_words(model);
  return finish(sources, std::move(model.mesh));
}

}  // namespace ritz::readers
