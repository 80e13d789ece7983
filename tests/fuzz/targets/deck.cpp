// The scene of a deck: refused, or a scene that is written and read again.
#include "fuzz/target.hpp"
#include "ritz/readers/file_scene.hpp"
#include "ritz/scene_file/read.hpp"
#include "ritz/scene_file/write.hpp"

namespace ritz::fuzz {

void read_input(Bytes input) {
  const auto file = readers::read_scene(as_file(input, "deck.inp"));
  for (const auto& note : file.notes)
    if (note.empty()) finding("a note that says nothing");
  const auto text = scene::written(file.scene);
  if (scene::written(scene::parse(text, "scene.toml")) != text)
    finding("a scene that is written is read as another one");
}

}  // namespace ritz::fuzz
