//! The panel: the attributes of the picked building, read from its grammar and changed with keys.

use std::fmt::Write as _;

use bevy::prelude::*;
use bevy_cga::{Cga, CgaModel, CgaRun};
use cga::{Attribute, Grammar, Text as CgaText, Value};

use crate::pick::Picked;
use crate::scene::Building;

/// The text of the panel.
#[derive(Component)]
#[require(Chosen, Values)]
pub(crate) struct PanelText;

/// The number of the chosen attribute.
#[derive(Component, Default)]
pub(crate) struct Chosen(usize);

/// The values that a run of the picked building uses, computed ones included. They are kept because default values of
/// attributes can be long computations.
#[derive(Component, Default)]
pub(crate) struct Values(Vec<(CgaText, Value)>);

pub(crate) fn add(mut commands: Commands) {
    let panel = Node {
        position_type: PositionType::Absolute,
        left: Val::Px(14.0),
        top: Val::Px(14.0),
        padding: UiRect::all(Val::Px(12.0)),
        border_radius: BorderRadius::all(Val::Px(6.0)),
        ..Node::default()
    };
    let font = TextFont { font_size: FontSize::Px(12.0), ..TextFont::default() };
    commands.spawn((
        panel,
        BackgroundColor(Color::srgba(0.06, 0.08, 0.11, 0.82)),
        children![(PanelText, Text::new(""), font, TextColor(Color::srgb(0.93, 0.94, 0.95)))],
    ));
}

/// The attributes that user interfaces show.
fn attributes(cga: &Cga) -> Vec<&Attribute> {
    cga.grammar.attributes().iter().filter(|attribute| !attribute.hidden).collect()
}

/// Changes the picked building: up and down choose an attribute, left and right change it, R resets it, N takes another
/// seed.
pub(crate) fn keys(
    keys: Res<ButtonInput<KeyCode>>,
    picked: Res<Picked>,
    mut chosen: Single<&mut Chosen>,
    mut buildings: Query<&mut Cga>,
) {
    let Some(mut cga) = picked.building.and_then(|building| buildings.get_mut(building).ok()) else { return };
    let shown = attributes(&cga);
    let Some(last) = shown.len().checked_sub(1) else { return };
    let pressed = |key| keys.just_pressed(key);
    if pressed(KeyCode::ArrowDown) {
        chosen.0 = (chosen.0 + 1).min(last);
    } else if pressed(KeyCode::ArrowUp) {
        chosen.0 = chosen.0.saturating_sub(1);
    }
    let attribute = shown[chosen.0.min(last)].clone();
    if pressed(KeyCode::ArrowLeft) || pressed(KeyCode::ArrowRight) {
        let value = used(&cga).into_iter().find(|(name, _)| *name == attribute.name);
        let next = value.and_then(|(_, value)| next(&attribute, &*cga.grammar, value, pressed(KeyCode::ArrowRight)));
        if let Some(next) = next
            && let Err(error) = cga.grammar.set(&attribute.name, next)
        {
            warn!("{error}");
        }
    } else if pressed(KeyCode::KeyR) {
        // It has the attribute.
        let _ = cga.grammar.reset(&attribute.name);
    } else if pressed(KeyCode::KeyN) {
        let seed = cga.shape.seed_value().wrapping_add(1);
        cga.shape = cga.shape.clone().seed(seed);
    }
}

/// The values that a run uses, computed ones included.
fn used(cga: &Cga) -> Vec<(CgaText, Value)> {
    cga.grammar.used_values(&cga.shape, &cga.settings).unwrap_or_default()
}

/// The next or the previous value of an attribute: of its choices, within its range, or the other truth value. Colours
/// come from a palette. `None` for other values.
fn next(attribute: &Attribute, grammar: &dyn Grammar, value: Value, is_up: bool) -> Option<Value> {
    const PALETTE: [&str; 8] = ["#e6d3b1", "#c9d1c8", "#d9b8a0", "#8fa3b5", "#b5533c", "#7c4a3c", "#5d5f63", "#f2efe8"];
    let beside = |list: Vec<Value>| {
        let at = list.iter().position(|known| *known == value);
        let step = if is_up { 1 } else { list.len().checked_sub(1)? };
        list.get(at.map_or(0, |at| (at + step) % list.len())).cloned()
    };
    if let Some(choices) = &attribute.choices {
        return beside(choices.of(grammar)?);
    }
    match &value {
        Value::Bool(truth) => Some(Value::Bool(!truth)),
        Value::Float(number) => {
            let (low, high) = attribute.range.map_or((f64::MIN, f64::MAX), |range| (range.min, range.max));
            let step = match attribute.range {
                Some(range) if 0.0 < range.step => range.step,
                Some(range) if range.max - range.min < 5.0 => (range.max - range.min) / 20.0,
                _ => 1.0,
            };
            let moved = if is_up { number + step } else { number - step };
            Some(Value::Float(moved.clamp(low, high)))
        }
        Value::Text(text) if text.starts_with('#') => {
            beside(PALETTE.iter().map(|color| Value::Text(CgaText::from(*color))).collect())
        }
        _ => None,
    }
}

/// Computes the values after a click on a building or a change of the picked one.
pub(crate) fn compute_values(picked: Res<Picked>, mut values: Single<&mut Values>, buildings: Query<Ref<Cga>>) {
    if let Some(cga) = picked.building.and_then(|building| buildings.get(building).ok())
        && (picked.is_changed() || cga.is_changed())
    {
        values.0 = used(&cga);
    }
}

/// Writes the panel.
pub(crate) fn refresh(
    picked: Res<Picked>,
    panel: Single<(&mut Text, &Chosen, &Values), With<PanelText>>,
    buildings: Query<(&Cga, &Building, Option<&CgaModel>, Has<CgaRun>)>,
) {
    let (mut text, chosen, values) = panel.into_inner();
    let wanted = match picked.building.and_then(|building| buildings.get(building).ok()) {
        None => "Click a building.\nW A S D E Q fly, the right button turns.".to_owned(),
        Some((cga, building, shown, is_running)) => {
            describe(cga, building, &values.0, shown, is_running, chosen.0, picked.rule.as_deref())
        }
    };
    if text.0 != wanted {
        text.0 = wanted;
    }
}

fn describe(
    cga: &Cga,
    building: &Building,
    values: &[(CgaText, Value)],
    shown: Option<&CgaModel>,
    is_running: bool,
    chosen: usize,
    rule: Option<&str>,
) -> String {
    let mut text = format!("Building {}, seed {}", building.0, cga.shape.seed_value());
    if let Some(rule) = rule {
        let _ = write!(text, ", rule {rule}");
    }
    text.push_str("\n\n");
    let list = attributes(cga);
    let last = list.len().saturating_sub(1);
    for (number, attribute) in list.iter().enumerate() {
        let name = if attribute.display_name.is_empty() { &attribute.name } else { &attribute.display_name };
        let value = values.iter().find(|(known, _)| *known == attribute.name);
        let value = value.map_or(String::new(), |(_, value)| shown_value(value));
        let mark = if number == chosen.min(last) { ">" } else { "  " };
        let is_set = cga.grammar.get(&attribute.name).is_ok_and(|value| Some(&value) != attribute.default.as_ref());
        let _ = writeln!(text, "{mark} {name}: {value}{}", if is_set { " *" } else { "" });
    }
    if let Some(about) = list.get(chosen.min(last)).map(|attribute| &attribute.about).filter(|about| !about.is_empty())
    {
        let _ = write!(text, "\n{about}");
    }
    let leaves = shown.map_or(0, |shown| shown.model.len());
    let _ = write!(text, "\n{leaves} parts{}", if is_running { ", another model is on its way" } else { "" });
    text.push_str("\n\nUp, Down: choose   Left, Right: change\nR: default   N: next seed");
    text
}

/// A value for a person.
fn shown_value(value: &Value) -> String {
    match value {
        Value::Float(number) => format!("{}", (number * 100.0).round() / 100.0),
        other => other.to_string(),
    }
}
