// Writes down what happens in one step, for those who want to see it slowly. Evaluates what it needs itself, with its
// own memory and its own count of work: the step does not notice.
#pragma once

#include <memory>

#include "core/energies/elastic.hpp"
#include "core/integrators/integrator.hpp"
#include "core/step_record.hpp"

namespace pf {

template <int D>
class StepRecorder final : public StepObserver {
 public:
  /// All are referred to; `grid` holds masses and v^n.
  StepRecorder(RecordLevel level, const Plan<D>& plan, const Particles<D>& particles, const Laws<D>& laws,
               const GridState<D>& grid, const MassKind& mass, Parallel& parallel);

  void begin_step(long step, double time, double dt, StepConditions<D>& conditions);
  void stage(double scale, const Vector& u_free, const Vector& loads, const Vector* inner) override;
  void begin() override;
  void iterate(const Vector& u, const Vector& left, const NewtonIteration& record) override;
  /// The step on the grid has ended; `iterations` as they stand in the report.
  std::shared_ptr<const StepRecord> solved(const std::vector<NewtonIteration>& iterations);
  /// The step was accepted: the particles are about to become `to`.
  void moved(const Motion<D>& to);

 private:
  bool all() const { return level_ == RecordLevel::all; }
  void keep_weights();
  void find_worst(const Vector& left, IterateRecord& iterate) const;

  RecordLevel level_;
  const Plan<D>& plan_;
  const Particles<D>& particles_;
  const GridState<D>& grid_;
  Work work_;  ///< counted apart, and forgotten
  MassMatrix<D> mass_;
  ElasticEnergy<D> elastic_;
  std::vector<bool> superseded_;  ///< one an iterate: the end of a minimisation that another one went on from
  std::shared_ptr<StepRecord> record_ = std::make_shared<StepRecord>();
};

extern template class StepRecorder<2>;
extern template class StepRecorder<3>;

}  // namespace pf
