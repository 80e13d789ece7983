#include "ritz/mesh/read_inp.hpp"

#include "ritz/mesh/read_inp_model.hpp"

namespace ritz::mesh {
namespace {

using Handler = void (*)(Deck&, const Keyword&, InpModel&);

void refuse_assembly(Deck& deck, const Keyword& keyword, InpModel&) {
  deck.fail(keyword.place, "parts and assemblies (*" + keyword.name + ") are not supported; flatten the model " +
                               "(write the input file without parts and assemblies)");
}

// Keywords that would change what the read ones mean.
void refuse(Deck& deck, const Keyword& keyword, InpModel&) {
  deck.fail(keyword.place, "*" + keyword.name + " is not supported; write the nodes and elements out");
}

const std::map<std::string, Handler, std::less<>>& handlers() {
  static const std::map<std::string, Handler, std::less<>> table = {{"NODE", read_inp_node},
                                                                    {"ELEMENT", read_inp_element},
                                                                    {"NSET", read_inp_nset},
                                                                    {"ELSET", read_inp_elset},
                                                                    {"SURFACE", read_inp_surface},
                                                                    {"MATERIAL", read_inp_material},
                                                                    {"ELASTIC", read_inp_elastic},
                                                                    {"DENSITY", read_inp_density},
                                                                    {"SOLIDSECTION", read_inp_section},
                                                                    {"BOUNDARY", read_inp_boundary},
                                                                    {"PART", refuse_assembly},
                                                                    {"INSTANCE", refuse_assembly},
                                                                    {"ASSEMBLY", refuse_assembly},
                                                                    {"SYSTEM", refuse},
                                                                    {"TRANSFORM", refuse},
                                                                    {"NGEN", refuse},
                                                                    {"NFILL", refuse},
                                                                    {"NCOPY", refuse},
                                                                    {"ELGEN", refuse},
                                                                    {"ELCOPY", refuse},
                                                                    {"NMAP", refuse}};
  return table;
}

}  // namespace

std::string needed(const Deck& deck, const Keyword& keyword, std::string_view parameter) {
  const auto value = keyword.value(parameter);
  if (!value) deck.fail(keyword.place, "*" + keyword.name + " needs " + std::string(parameter) + "=");
  return *value;
}

FileMesh read_inp(Sources& sources, unsigned file, const Ignored&) {
  Deck deck(sources, file);
  InpModel model;
  while (const auto keyword = deck.next_keyword()) {
    const auto handler = handlers().find(keyword->name);
    if (handler != handlers().end()) handler->second(deck, *keyword, model);
  }
  return resolve_inp(sources, std::move(model));
}

}  // namespace ritz::mesh
