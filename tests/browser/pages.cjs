// Opens pages in Debian's Chromium and says as JSON what it found there.
//
//   node pages.cjs film PAGE.html [PICTURE.png]      a page of one film
//   node pages.cjs gallery SITE/index.html [PICTURE.png]   a site
//   node pages.cjs slides SLIDES/index.html [PICTURE.png]  slides of Reveal.js; PICTURE of the first
//   node pages.cjs pictures PAGE.html FOLDER         screenshots at three widths, light and dark
//   node pages.cjs picture PAGE.html PICTURE.png WIDTH HEIGHT   one screenshot
//   node pages.cjs inlined PAGE.html     whether each of several SVGs in a page looks as it does alone
//
// NODE_PATH leads to playwright-core and axe-core.
'use strict';
const path = require('path');
const { pathToFileURL } = require('url');
const { chromium } = require('playwright-core');
const axe = require.resolve('axe-core/axe.min.js');

const flags = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--autoplay-policy=no-user-gesture-required'];
const rules = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'];

// Whatever a page should not do: scripts of others, requests beyond its folder, messages, dialogs.
function watched(page) {
  const bad = [];
  page.on('console', said => { if (['error', 'warning'].includes(said.type())) bad.push(`${said.type()}: ${said.text()}`); });
  page.on('pageerror', error => bad.push(`script: ${error.message}`));
  page.on('dialog', dialog => { bad.push(`dialog: ${dialog.message()}`); dialog.dismiss(); });
  page.on('request', request => { if (!/^(file|data|blob):/.test(request.url())) bad.push(`request: ${request.url()}`); });
  page.on('requestfailed', request => {  // a film that is no longer asked for is not fetched to its end
    if (request.failure().errorText !== 'net::ERR_ABORTED') bad.push(`${request.failure().errorText}: ${request.url().slice(0, 200)}`);
  });
  return bad;
}

async function violations(page, preload = true) {
  const found = [];
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    // The page's own policy forbids scripts that are added: this one comes by the debugger.
    if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(require('fs').readFileSync(axe, 'utf8'));
    const result = await page.evaluate(([tags, preload]) => window.axe.run(document, { runOnly: { type: 'tag', values: tags }, preload }), [rules, preload]);
    for (const one of result.violations)
      found.push(`${colorScheme}: ${one.id}: ${one.nodes.map(node => node.html.slice(0, 120)).join(' | ')}`);
  }
  return found;
}

const time = page => page.evaluate(() => document.getElementById('film').currentTime);

async function seeked(page, at) {
  await page.waitForFunction(wanted => {
    const film = document.getElementById('film');
    return !film.seeking && Math.abs(film.currentTime - wanted) < 0.05;
  }, at, { timeout: 20000 }).catch(() => {});
}

async function film(page, url) {
  await page.goto(url);
  await page.waitForFunction(() => document.getElementById('film').readyState >= 1, null, { timeout: 30000 });
  const answer = await page.evaluate(() => {
    const its = document.getElementById('film');
    return { title: document.title, heading: document.querySelector('h1').textContent, duration: its.duration,
      width: its.videoWidth, height: its.videoHeight, scripts: document.scripts.length, tracks: Array.from(its.textTracks, track => track.kind), changed: typeof window.changed };
  });
  answer.paused = await page.evaluate(() => document.getElementById('film').paused);
  // Chapters, by the pointer and by the keyboard.
  const buttons = page.locator('.chapters button');
  answer.chapters = [];
  for (let i = 0; i < await buttons.count(); ++i) {
    const at = Number(await buttons.nth(i).getAttribute('data-at'));
    if (i % 2) {
      await buttons.nth(i).focus();
      await page.keyboard.press('Enter');
    } else {
      await buttons.nth(i).click();
    }
    await seeked(page, at);
    answer.chapters.push({ at, reached: await time(page), words: await buttons.nth(i).innerText(),
      current: await buttons.nth(i).getAttribute('aria-current') });
  }
  // Captions: the cues of each track, and those that show at some times.
  answer.captions = await page.evaluate(async () => {
    const its = document.getElementById('film');
    const track = Array.from(its.textTracks).find(one => one.kind === 'captions');
    if (!track) return null;
    track.mode = 'showing';
    for (let i = 0; i < 100 && !(track.cues && track.cues.length); ++i) await new Promise(wake => setTimeout(wake, 50));
    const cues = Array.from(track.cues || [], cue => ({ start: cue.startTime, end: cue.endTime, words: cue.text }));
    const shown = [];
    for (const cue of cues) {
      its.currentTime = (cue.start + cue.end) / 2;
      for (let i = 0; i < 100; ++i) {
        await new Promise(wake => setTimeout(wake, 50));
        if (!its.seeking && track.activeCues.length) break;
      }
      shown.push(Array.from(track.activeCues, active => active.text).join(' / '));
    }
    track.mode = 'disabled';
    return { cues, shown };
  });
  // It plays, by the keyboard too.
  await page.evaluate(() => { document.getElementById('film').currentTime = 0; });
  await seeked(page, 0);
  await page.locator('#film').focus();
  await page.keyboard.press('Space');
  await page.waitForFunction(() => document.getElementById('film').currentTime > 0.2, null, { timeout: 20000 }).catch(() => {});
  answer.played = await time(page);
  answer.heard = await page.evaluate(() => document.getElementById('film').webkitAudioDecodedByteCount);
  await page.evaluate(() => document.getElementById('film').pause());
  answer.downloads = await page.evaluate(() => Array.from(document.querySelectorAll('a[download]'), link =>
    ({ name: link.download, address: link.getAttribute('href').slice(0, 60) })));
  answer.scene = await page.evaluate(() => {
    const address = document.querySelector('a[download]').getAttribute('href');
    if (!address.startsWith('data:')) return null;
    const bytes = Uint8Array.from(atob(address.slice(address.indexOf(',') + 1)), letter => letter.charCodeAt(0));
    return new TextDecoder().decode(bytes);
  });
  // A film beside a page that comes from a folder is opened, not saved: browsers take it for one of another site.
  const inside = await page.evaluate(() => document.querySelector('source').src.startsWith('data:'));
  const saving = inside ? page.waitForEvent('download', { timeout: 20000 }).catch(() => null) : null;
  if (inside) await page.locator('#save').click();
  const saved = await saving;
  answer.saved = saved ? { name: saved.suggestedFilename(), bytes: require('fs').statSync(await saved.path()).size } : null;
  answer.wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  answer.violations = await violations(page);
  return answer;
}

const shown = page => page.evaluate(() => document.querySelectorAll('.card:not([hidden])').length);

async function gallery(page, url) {
  await page.goto(url);
  const cards = page.locator('.card');
  const answer = { title: await page.title(), cards: await cards.count(), sections: await page.locator('h2').allInnerTexts(),
    changed: await page.evaluate(() => typeof window.changed) };
  answer.videos = await page.locator('video').count();
  answer.links = await page.evaluate(() => Array.from(document.querySelectorAll('.card a'), link => link.href));
  answer.titles = await page.locator('.card h3').allInnerTexts();
  // Films on demand: under the pointer, with the focus, gone with Escape, and none for those who want no motion.
  const link = page.locator('.card a').first();
  const plays = () => page.waitForFunction(() => {
    const its = document.querySelector('.card video');
    return its && its.currentTime > 0.1;
  }, null, { timeout: 20000 }).then(() => true, () => false);
  await link.hover();
  answer.hover = await plays();
  await page.mouse.move(0, 0);
  answer.left = await page.locator('video').count();
  await link.focus();
  answer.focus = await plays();
  await page.keyboard.press('Escape');
  answer.escaped = await page.locator('video').count();
  await page.evaluate(() => document.activeElement.blur());
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await link.hover();
  await page.waitForTimeout(600);
  answer.calm = await page.locator('video').count();
  await page.mouse.move(0, 0);
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  // The search, by the keyboard; a word of the first card, in capitals.
  const word = (await page.locator('.card h3').first().innerText()).split(/\s+/).sort((a, b) => b.length - a.length)[0];
  await page.locator('#search').focus();
  await page.keyboard.type(word.toUpperCase());
  answer.found = await shown(page);
  answer.said = await page.locator('.search output').innerText();
  answer.hash = await page.evaluate(() => location.hash);
  await page.reload();
  answer.foundAgain = await shown(page);
  await page.locator('#search').fill('no such word anywhere');
  answer.none = await shown(page);
  answer.saidNone = await page.locator('.search output').innerText();
  await page.locator('#search').fill('');
  answer.all = await shown(page);
  await page.keyboard.press('Tab');
  answer.next = await page.evaluate(() => document.activeElement.className || document.activeElement.tagName);
  answer.violations = await violations(page);
  return answer;
}

// What the film of a slide does; `at` is the number of the slide.
const filmOf = (page, at) => page.evaluate(number => {
  const film = document.querySelectorAll('.slides > section')[number].querySelector('video');
  return { paused: film.paused, time: film.currentTime };
}, at);

// Whether the film of a slide plays: its time goes on.
async function goesOn(page, at) {
  const before = (await filmOf(page, at)).time;
  return page.waitForFunction(([number, time]) => {
    const film = document.querySelectorAll('.slides > section')[number].querySelector('video');
    return !film.paused && film.currentTime > time + 0.1;
  }, [at, before], { timeout: 20000 }).then(() => true, () => false);
}

async function stands(page, at) {
  const before = await filmOf(page, at);
  await page.waitForTimeout(400);
  const after = await filmOf(page, at);
  return before.paused && after.paused && before.time === after.time;
}

// Where a slide is on the screen, and what of the film is covered: nothing should be.
const drawn = (page, at) => page.evaluate(number => {
  const slide = document.querySelectorAll('.slides > section')[number], box = slide.querySelector('video').getBoundingClientRect();
  const strip = slide.querySelector('.strip').getBoundingClientRect();
  const points = [[0.5, 0.5], [0.01, 0.01], [0.99, 0.01], [0.01, 0.99], [0.99, 0.99]];
  return { bare: points.every(([x, y]) => document.elementFromPoint(box.left + x * box.width, box.top + y * box.height).tagName === 'VIDEO'),
    inside: box.left >= 0 && box.top >= 0 && box.right <= innerWidth && strip.bottom <= innerHeight + 1 && box.bottom <= strip.top + 1,
    share: box.width * box.height / (innerWidth * innerHeight) };
}, at);

async function slides(page, url) {
  await page.goto(url);
  await page.waitForFunction(() => window.Reveal && Reveal.isReady());
  const answer = { title: await page.title(), language: await page.evaluate(() => document.documentElement.lang), changed: await page.evaluate(() => typeof window.changed) };
  answer.slides = await page.evaluate(() => Array.from(document.querySelectorAll('.slides > section'), slide => {
    const film = slide.querySelector('video'), color = element => getComputedStyle(element).color;
    return { heading: slide.querySelector('h2').textContent, language: slide.lang, background: slide.dataset.backgroundColor, ink: color(slide),
      film: film.querySelector('source').getAttribute('src'), poster: film.getAttribute('poster'), label: film.getAttribute('aria-label'),
      about: document.getElementById(film.getAttribute('aria-describedby')).textContent, direction: getComputedStyle(slide.querySelector('h2')).direction,
      play: slide.querySelector('.play').getAttribute('aria-label'), tracks: Array.from(film.textTracks, track => track.kind),
      notes: slide.querySelector('aside.notes').innerText || slide.querySelector('aside.notes').textContent };
  }));
  const last = answer.slides.length - 1, play = at => page.locator('.slides > section').nth(at).locator('.play');
  await page.waitForFunction(() => Reveal.getCurrentSlide().querySelector('video').readyState >= 2, null, { timeout: 30000 });
  await page.waitForTimeout(500);
  answer.before = await stands(page, 0);
  answer.drawn = await drawn(page, 0);
  answer.poster = await page.evaluate(() => new Promise(done => {
    const image = new Image(); image.onload = () => done(image.naturalWidth); image.onerror = () => done(0);
    image.src = document.querySelector('video').poster;
  }));
  // A click on the film starts it, the next one stops it; so do the space bar and the button.
  const middle = page.locator('.slides > section').nth(0).locator('video');
  await middle.click();
  answer.clicked = await goesOn(page, 0);
  await middle.click();
  answer.clickedAgain = await stands(page, 0);
  await page.keyboard.press('Space');
  answer.spaced = await goesOn(page, 0);
  await page.keyboard.press('k');
  answer.stopped = await stands(page, 0);
  await play(0).focus();
  await page.keyboard.press('Enter');
  answer.entered = await goesOn(page, 0);
  await page.keyboard.press('Space');
  answer.buttonStopped = await stands(page, 0);
  answer.words = await play(0).getAttribute('aria-label');
  // The slider belongs to the arrows when it has the focus, and to nobody after a click.
  const slider = page.locator('.slides > section').nth(0).locator('input');
  await slider.focus();
  await page.keyboard.press('Home');
  await page.waitForFunction(() => document.querySelector('video').currentTime < 0.05, null, { timeout: 20000 }).catch(() => {});
  answer.rewound = (await filmOf(page, 0)).time;
  await page.keyboard.press('ArrowRight');
  answer.kept = await page.evaluate(() => Reveal.getIndices().h);
  await page.evaluate(() => document.activeElement.blur());
  const button = page.locator('.slides > section').nth(0).locator('.captions');
  if (await button.count()) {
    await button.click();
    answer.captions = await page.evaluate(async () => {
      const track = Array.from(document.querySelector('video').textTracks).find(one => one.kind === 'captions');
      for (let i = 0; i < 100 && !(track.cues && track.cues.length); ++i) await new Promise(wake => setTimeout(wake, 50));
      return { mode: track.mode, cues: Array.from(track.cues || [], cue => cue.text) };
    });
    // By the keyboard: the space bar is the button's then, and not the film's.
    await button.focus();
    await page.keyboard.press('Space');
    answer.captions.after = await page.evaluate(() => Array.from(document.querySelector('video').textTracks).find(one => one.kind === 'captions').mode);
    answer.captions.stood = await stands(page, 0);
    await page.evaluate(() => document.activeElement.blur());
  }
  if (last > 0) {
    // The film stops when its slide is left, and the next one waits.
    await page.evaluate(() => { document.querySelector('video').currentTime = 0; });
    await page.keyboard.press('Space');
    answer.playsAgain = await goesOn(page, 0);
    await page.keyboard.press('ArrowRight');
    answer.at = await page.evaluate(() => Reveal.getIndices().h);
    answer.left = await stands(page, 0);
    await page.waitForTimeout(500);
    answer.waits = await stands(page, 1);
    answer.titleNow = await page.title();
    // The one key of a presenter.
    await page.keyboard.press('PageDown');
    answer.presented = await goesOn(page, 1);
    answer.stays = await page.evaluate(() => Reveal.getIndices().h);
    await page.keyboard.press('PageUp');
    answer.back = await page.evaluate(() => Reveal.getIndices().h);
    answer.leftByPresenter = await stands(page, 1);
    await page.locator('.slides > section').nth(0).locator('.next').click();
    answer.turned = await page.evaluate(() => Reveal.getIndices().h);
  }
  // What the speaker sees.
  const opening = page.context().waitForEvent('page', { timeout: 20000 }).catch(() => null);
  await page.keyboard.press('s');
  const speaker = await opening;
  if (speaker) {
    const bad = watched(speaker);
    await speaker.waitForFunction(() => { const its = document.querySelector('.speaker-controls-notes .value'); return its && its.innerText.trim() !== ''; }, null, { timeout: 20000 }).catch(() => {});
    answer.speaker = { notes: await speaker.evaluate(() => { const its = document.querySelector('.speaker-controls-notes .value'); return its && its.innerText; }), bad };
    await speaker.close();
  }
  answer.overview = await page.evaluate(() => { Reveal.toggleOverview(true); Reveal.toggleOverview(false); return true; });
  await page.evaluate(() => Reveal.slide(0));
  answer.violations = await violations(page, false);  // the policy of the page keeps axe from fetching style sheets
  return answer;
}

// Each picture is compared at the same place with and without the others, so that pixels can be equal.
async function inlined(page, url) {
  const shot = index => page.locator(`svg >> nth=${index}`).screenshot();
  await page.goto(url);
  const count = await page.locator('svg').count();
  const answer = { same: [], bytes: [] };
  for (let i = 0; i < count; ++i) {
    await page.goto(url);
    const together = await shot(i);
    await page.evaluate(kept => document.querySelectorAll('svg').forEach((svg, k) => { if (k !== kept) svg.replaceChildren(); }), i);
    answer.same.push(together.equals(await shot(i)));
    answer.bytes.push(together.length);
  }
  return answer;
}

async function pictures(browser, url, folder) {
  for (const width of [390, 820, 1440])
    for (const colorScheme of ['light', 'dark']) {
      const page = await browser.newPage({ viewport: { width, height: 900 }, colorScheme });
      await page.goto(url);
      await page.waitForTimeout(1000);
      const name = path.basename(url, '.html');
      await page.screenshot({ path: path.join(folder, `${name}-${width}-${colorScheme}.png`) });
      await page.close();
    }
  return {};
}

async function picture(browser, url, file, width, height) {
  const page = await browser.newPage({ viewport: { width: Number(width), height: Number(height) } });
  await page.goto(url);
  await page.waitForLoadState('networkidle');
  await page.waitForTimeout(2000);  // until players have faded in what they show
  await page.screenshot({ path: file });
  return {};
}

(async () => {
  const [mode, file, more, width, height] = process.argv.slice(2);
  const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: flags });
  try {
    const url = /^https?:/.test(file) ? file : pathToFileURL(path.resolve(file)).href;
    if (mode === 'pictures') return console.log(JSON.stringify(await pictures(browser, url, more)));
    if (mode === 'picture') return console.log(JSON.stringify(await picture(browser, url, more, width, height)));
    const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
    const bad = watched(page);
    const answer = await { film, gallery, slides, inlined }[mode](page, url);
    if (more) await page.screenshot({ path: more, fullPage: true });
    console.log(JSON.stringify({ ...answer, bad }));
  } finally {
    await browser.close();
  }
})().catch(error => {
  console.error(error.stack);
  process.exit(1);
});
