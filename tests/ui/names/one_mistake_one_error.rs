use cga::{Settings, Shape, cga};

cga! {
    /// Everything the program uses is there, though the rules have a mistake.
    pub grammar Tower;
    attr height = 3
    attr name = "x"
    attr tall = height > 2
    attr drawn = 30% : "a" else : "b"
    attr constant = 2 * max(unit, 3) + unit
    const unit = 3
    Lot --> extrud(height) A.
}

fn run(grammar: &dyn Fn(&Shape) -> Result<cga::Model, cga::Error>) -> bool {
    grammar(&Shape::rectangle(1.0, 1.0)).is_ok()
}

fn main() {
    let mut tower = Tower { height: 4.0, name: String::from("y"), tall: Some(true), constant: 3.0, ..Tower::default() };
    tower.height += 1.0;
    tower.drawn = Some("c".into());
    let shape = Shape::rectangle(1.0, 1.0);
    run(&|shape| tower.generate(shape));
    tower.clone().generate_from("Lot", &shape).unwrap();
    tower.generate_with(&shape, &Settings::default()).unwrap();
    tower.run(&shape, &Settings::default(), &mut cga::Model::new()).unwrap();
    tower.session(&Settings::default()).unwrap().run(&shape, &mut cga::Model::new()).unwrap();
    tower.generate_all(&[shape.clone()], &Settings::default()).unwrap().to_obj("tower.mtl");
    cga::parallel::run_all(&tower, &[shape.clone()], &Settings::default(), |_| cga::Model::new()).unwrap();
    println!("{tower:?}");

    let (width, height) = (2.0, 3.0);
    let mut rules = cga! {
        attr depth = 2
        Lot --> s(#width, #height, dept) A.
    };
    rules.depth = 3.0;
    rules.clone().generate(&shape).unwrap();
}
