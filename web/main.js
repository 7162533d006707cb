// Starts the application.
import {App} from './app.js';
import {restoreTheme} from './theme.js';

restoreTheme();
window.continua = new App(document.getElementById('page'));
