impl Tower {
    /// Runs the start rule on a shape, with default settings.
    ///
    /// # Errors
    /// An error if a limit is reached, an attribute is out of its range, attributes need each other, the start rule does not exist, or
    /// the initial shape is refused.
    pub fn generate(
        &self,
        shape: &cga_rt::Shape,
    ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
        cga_rt::generate(self, shape, &::core::default::Default::default())
    }
    /// Runs the rule of that name on a shape, with default settings.
    ///
    /// # Errors
    /// An error if a limit is reached, an attribute is out of its range, attributes need each other, the start rule does not exist, or
    /// the initial shape is refused.
    pub fn generate_from(
        &self,
        rule: &::core::primitive::str,
        shape: &cga_rt::Shape,
    ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
        cga_rt::generate_from(self, rule, shape)
    }
    /// Runs on a shape with settings: start rule, limits, assets.
    ///
    /// # Errors
    /// An error if a limit is reached, an attribute is out of its range, attributes need each other, the start rule does not exist, or
    /// the initial shape is refused.
    pub fn generate_with(
        &self,
        shape: &cga_rt::Shape,
        settings: &cga_rt::Settings,
    ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
        cga_rt::generate(self, shape, settings)
    }
    /// Runs on a shape and hands the leaves to a sink. This is the fast path: no model in between.
    ///
    /// # Errors
    /// An error if a limit is reached, an attribute is out of its range, attributes need each other, the start rule does not exist, or
    /// the initial shape is refused.
    pub fn run<Sink: cga_rt::Sink + ?::core::marker::Sized>(
        &self,
        shape: &cga_rt::Shape,
        settings: &cga_rt::Settings,
        sink: &mut Sink,
    ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
        cga_rt::run(self, shape, settings, sink)
    }
    /// The old name of `run`.
    ///
    /// # Errors
    /// An error if a limit is reached, an attribute is out of its range, attributes need each other, the start rule does not exist, or
    /// the initial shape is refused.
    #[deprecated(note = "call `run`")]
    pub fn generate_into<Sink: cga_rt::Sink + ?::core::marker::Sized>(
        &self,
        shape: &cga_rt::Shape,
        settings: &cga_rt::Settings,
        sink: &mut Sink,
    ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
        cga_rt::run(self, shape, settings, sink)
    }
    /// Opens a session: several runs with the same settings, which share what is made once.
    ///
    /// # Errors
    /// An attribute out of its range, no such start rule.
    pub fn session(
        &self,
        settings: &cga_rt::Settings,
    ) -> ::core::result::Result<cga_rt::Session<'_, Self>, cga_rt::Error> {
        cga_rt::Session::new(self, settings)
    }
    /// Runs on many shapes, in parallel with the feature `rayon`, and collects a model of each.
    ///
    /// # Errors
    /// The first error in the order of the shapes.
    #[inline]
    pub fn generate_all(
        &self,
        shapes: &[cga_rt::Shape],
        settings: &cga_rt::Settings,
    ) -> ::core::result::Result<cga_rt::Batches<cga_rt::Model>, cga_rt::RunError> {
        cga_rt::generate_all(self, shapes, settings)
    }
    /// Runs on many shapes, in parallel with the feature `rayon`, with a sink for each stretch of shapes.
    ///
    /// # Errors
    /// The first error in the order of the shapes.
    pub fn run_all<Sink: cga_rt::Sink + ::core::marker::Send>(
        &self,
        shapes: &[cga_rt::Shape],
        settings: &cga_rt::Settings,
        sink: impl ::core::ops::Fn(&cga_rt::Stretch) -> Sink + ::core::marker::Sync,
    ) -> ::core::result::Result<cga_rt::Batches<Sink>, cga_rt::RunError> {
        cga_rt::run_all(self, shapes, settings, sink)
    }
    /// The old name of `run_all`.
    ///
    /// # Errors
    /// The first error in the order of the shapes.
    #[deprecated(note = "call `run_all`")]
    pub fn generate_all_into<Sink: cga_rt::Sink + ::core::marker::Send>(
        &self,
        shapes: &[cga_rt::Shape],
        settings: &cga_rt::Settings,
        sink: impl ::core::ops::Fn(&cga_rt::Stretch) -> Sink + ::core::marker::Sync,
    ) -> ::core::result::Result<cga_rt::Batches<Sink>, cga_rt::RunError> {
        cga_rt::run_all(self, shapes, settings, sink)
    }
}
