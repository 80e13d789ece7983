#include "ritz/app/outputs.hpp"

#include <utility>

#include "ritz/app/export.hpp"
#include "ritz/app/full_file.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {

PendingFile::PendingFile(MPI_Comm comm, const std::filesystem::path& path) : comm_(comm) {
  std::string part;
  parallel::on_root(comm, [&] { part = file_.emplace(path).part().string(); });
  parallel::broadcast(comm, part);
  part_ = part;
}

void PendingFile::write(const std::string& text) const {
  parallel::on_root(comm_, [&] { file_->write(text); });
}

void PendingFile::finish() const {
  parallel::on_root(comm_, [&] { file_->finish(); });
}

void PendingFile::publish() {
  parallel::on_root(comm_, [&] { file_->publish(); });
}

namespace {

namespace fs = std::filesystem;

files::Named of_option(const std::string& option, const fs::path& path) {
  return {"option -" + option + " " + path.string(), path};
}

files::Named beside(const std::string& what, const fs::path& path) {
  return {what + " " + path.string() + " beside the output", path};
}

/// What both programs read, and what PETSc writes for them.
files::Plan common(const config::Config& config) {
  files::Plan plan{.outputs = {}};
  if (const auto* mesh = std::get_if<fs::path>(&config.source.mesh)) plan.inputs.push_back(of_option("mesh", *mesh));
  for (const auto& list : config.source.vertex_lists) plan.inputs.push_back(of_option("fix", list));
  for (const auto& file : config.option_files) plan.inputs.push_back(of_option("options_file", file));
  if (config.accuracy) plan.inputs.push_back(of_option("accuracy_scene", config.accuracy->scene));
  if (config.snapshots) plan.inputs.push_back(of_option("snapshots", *config.snapshots));
  for (const auto& [name, file] : config.reports) plan.reports.push_back({"option -" + name + " :" + file, file});
  return plan;
}

}  // namespace

Outputs::Outputs(MPI_Comm comm, const files::Plan& plan) : comm_(comm) {
  parallel::on_root(comm, [&] { claim_.emplace(plan); });
}

void Outputs::refuse_inputs(const std::vector<fs::path>& read) const {
  parallel::on_root(comm_, [&] {
    std::vector<files::Named> inputs;
    for (const auto& file : read) inputs.push_back({"the file " + file.string() + " of the mesh", file});
    claim_->refuse(inputs);
  });
}

void Outputs::publish(const std::function<void()>& give_names) const {
  parallel::on_root(comm_, [&] { claim_->verify(); });
  const files::Uninterrupted together;
  give_names();
  if (claim_) claim_->say_published();
}

std::string Outputs::replaced() const {
  const auto files = claim_ ? claim_->replaced() : std::string();
  return files.empty() ? "" : files + "\n";
}

Outputs claim_model(MPI_Comm comm, const config::Config& config) {
  auto plan = common(config);
  plan.outputs.push_back(of_option("output", config.output));
  if (config.summary) plan.outputs.push_back(of_option("summary", *config.summary));
  if (config.reuse) plan.replaceable.push_back(of_option("reuse", *config.reuse));
  plan.outputs.push_back(beside("the table", files::table_beside(config.output, "frequencies")));
  for (const auto& file : exported_files(config)) plan.outputs.push_back(beside("the matrix", file));
  if (const auto link = fs::path(config.output).replace_extension(".hdf"); link != config.output)
    plan.links.push_back(beside("the link", link));
  return {comm, plan};
}

std::optional<Outputs> claim_reports(MPI_Comm comm, const config::Config& config) {
  if (config.reports.empty() && !config.summary) return std::nullopt;
  auto plan = common(config);
  if (config.summary) plan.outputs.push_back(of_option("summary", *config.summary));
  if (config.reuse) plan.inputs.push_back(of_option("reuse", *config.reuse));
  plan.links.push_back(of_option("output", config.output));
  return Outputs(comm, plan);
}

Outputs claim_motion(MPI_Comm comm, const config::Config& config, const scene::Scene& scene) {
  auto plan = common(config);
  plan.outputs.push_back(of_option("output", config.output));
  if (config.summary) plan.outputs.push_back(of_option("summary", *config.summary));
  plan.inputs.push_back(of_option("scene", config.full.scene));
  const auto* stored = scene.initial ? std::get_if<scene::StoredStart>(&*scene.initial) : nullptr;
  if (stored != nullptr && !config.full.restart) {
    plan.inputs.push_back({"the motion " + stored->motion.string() + " of [initial]", stored->motion});
    if (!stored->model.empty())
      plan.inputs.push_back({"the model " + stored->model.string() + " of [initial]", stored->model});
  }
  if (config.full.restart) plan.replaceable.push_back(of_option("restart", *config.full.restart));
  if (config.full.frames.value_or(1) > 0)
    plan.outputs.push_back(beside("the file", format::xdmf_path(config.output, "-output " + config.output.string())));
  if (std::holds_alternative<scene::Time>(scene.analysis))
    plan.outputs.push_back(beside("the table", files::table_beside(config.output, "energy")));
  if (!scene.probes.empty()) plan.outputs.push_back(beside("the table", files::table_beside(config.output, "probes")));
  if (config.full.timing) plan.outputs.push_back(of_option("timing", *config.full.timing));
  return {comm, plan};
}

}  // namespace ritz::app
